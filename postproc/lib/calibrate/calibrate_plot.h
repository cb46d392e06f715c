// SPDX-License-Identifier: GPL-2.0-or-later
// calibrate.png: each measured figure over each constant.
// Scope: a frame holds the runs of the sweep, the surface through the estimate, and the measure.
#pragma once

#include <string>
#include <vector>

#include "calibrate/calibration.h"
#include "draw/panels.h"

namespace muckpile {

struct PlottedConstant {
  std::string label;  // "energy share"
  LogScale scale;
};

struct PlottedFigure {
  std::string label;
  double measured, uncertainty;
  Eigen::MatrixXd places;  // a row per run
  Eigen::VectorXd values;  // of the runs
};

[[nodiscard]] Panels plot_of_calibration(const std::vector<PlottedConstant>& constants,
                                         const std::vector<PlottedFigure>& figures,
                                         const std::vector<Target>& targets,
                                         const Calibration& calibration);

}  // namespace muckpile
