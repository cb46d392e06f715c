// SPDX-License-Identifier: GPL-2.0-or-later
// Surveyed ground as a floor of panels that goes on beyond the survey, and a step down at one side.
// Scope: ground without overhangs; between the corners of panels the floor is straight.
#pragma once

#include <vector>

#include "geometry/files/stl_file.h"
#include "geometry/surface/surface_index.h"

namespace muckpile {

/// Heights of surveyed ground at any place in plan.
class GroundHeights {
 public:
  /// Throws InputError, which begins with `where`, where no triangle looks up.
  GroundHeights(const std::vector<StlTriangle>& triangles, const std::string& where);

  /// Beyond the survey that of its nearest place in plan [m].
  [[nodiscard]] double at(double x, double y) const;
  [[nodiscard]] bool covers(double x, double y) const;
  [[nodiscard]] const Vec3& lo() const { return plan_.lo(); }  // of the survey in plan [m]
  [[nodiscard]] const Vec3& hi() const { return plan_.hi(); }

 private:
  std::vector<StlTriangle> triangles_;
  SurfaceIndex plan_;  // the same, all laid on z = 0
};

struct FloorExtent {
  double x_lo, x_hi, y_lo, y_hi;  ///< [m]
  double bottom;  ///< of the step at x_lo; the lowest ground where that is lower [m]
  double cell;    ///< about the width of panels where there is a survey [m]
};

struct SurveyedFloor {
  std::vector<StlTriangle> triangles;  ///< of the floor up, of the step to -x
  double lowest, highest;              ///< of the floor [m]
  double cell;                         ///< wider than asked for where the survey is large [m]
};

/// Panels of two triangles each; within the floor, and within the ground beside, they share their
/// corners to the last digit. Beyond the survey they grow with the distance from it.
[[nodiscard]] SurveyedFloor surveyed_floor(const GroundHeights& ground, FloorExtent extent);

}  // namespace muckpile
