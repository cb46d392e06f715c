// SPDX-License-Identifier: GPL-2.0-or-later
// Uncertain constants from measured figures, by least squares on response surfaces, and which
// combinations of them the measures do not tell.
// Scope: within the swept range; nothing is extrapolated.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "calibrate/response_surface.h"

namespace muckpile {

// One measured figure, its surface, and the standard deviation of the one about the other.
struct Target {
  double value, deviation;  // deviation > 0
  ResponseSurface surface;
};

// A combination of the constants. The measures fix it to 1/sharpness in places: half a swept range
// is 1.
struct Direction {
  double sharpness;     // singular value of the slopes over the deviations
  Eigen::VectorXd way;  // unit length, in places
  // A place that is known only to lie within the swept range has a standard deviation of 1/sqrt(3).
  [[nodiscard]] bool is_resolved() const { return sharpness * sharpness > 3.0; }
};

struct Calibration {
  Eigen::VectorXd place;              // of each constant, -1 to 1
  Eigen::MatrixXd covariance;         // of the places; 1/3 along what is not resolved
  std::vector<Direction> directions;  // the sharpest first, as many as constants
  double misfit = 0.0;                // sum of squared differences over deviations
  [[nodiscard]] size_t resolved() const;
  [[nodiscard]] bool at_edge(size_t constant) const;  // the sweep should go on there
};

// Gauss-Newton with damping in the resolved directions alone (truncated singular values), from the
// middle of the sweep: along what is not resolved the constants stay there. Other starts count
// where their misfit is less by more than 1.
[[nodiscard]] Calibration calibrate(const std::vector<Target>& targets, size_t constants);

}  // namespace muckpile
