// SPDX-License-Identifier: GPL-2.0-or-later
// A surveyed surface in the coordinates of a run, and its heights over a grid of columns.
// Scope: the highest point above each column's middle, as seen from above; nothing is guessed
// across gaps.
#pragma once

#include <optional>
#include <vector>

#include "geometry/files/survey_file.h"
#include "measure/columns.h"

namespace muckpile {

// From the file's axes to the run's: first shifted, then turned about the run's z axis.
struct SurveyPose {
  Vec3 shift = Vec3::Zero();  // [m]
  double turn = 0.0;          // counter-clockwise seen from above [rad]
  [[nodiscard]] Vec3 of(const Vec3& point) const {
    return Eigen::AngleAxisd(turn, Vec3::UnitZ()) * (point + shift);
  }
  // The inverse of that.
  [[nodiscard]] Vec3 back(const Vec3& point) const {
    return Eigen::AngleAxisd(-turn, Vec3::UnitZ()) * point - shift;
  }
  // The shift that brings `point` to `place`.
  [[nodiscard]] Vec3 shift_to(const Vec3& point, const Vec3& place) const {
    return Eigen::AngleAxisd(-turn, Vec3::UnitZ()) * place - point;
  }
};

SurveyedSurface placed(SurveyedSurface surface, const SurveyPose& pose);
Extent extent_of(const SurveyedSurface& surface);

// Whether any of its points or corners has such a height [m].
bool has_height_between(const SurveyedSurface& surface, double low, double high);

// In height, of what is no farther than `farthest` [m] from the middle one of all heights that
// differ: a number that stands for no data counts once, however often it occurs.
Extent extent_of_most(const SurveyedSurface& surface, double farthest);

// Height of the surface at each cell [m], NaN where it has none. Points are thinned to their means
// over a cell and joined to triangles whose sides are no longer than `gap` [m] in plan; by default
// five times the mean distance of neighbours over the grid and a few cells around it.
std::vector<double> heights_over(const ColumnGrid& grid, const SurveyedSurface& surface,
                                 std::optional<double> gap);

}  // namespace muckpile
