// SPDX-License-Identifier: GPL-2.0-or-later
// Surveyed ground as a floor of panels that goes on beyond the survey, and walls below its edges.
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
  double cell;                    ///< about the width of panels where there is a survey [m]
};

struct SurveyedFloor {
  std::vector<StlTriangle> triangles;  ///< they look up
  std::vector<Vec3> edge;              ///< corners of panels at x_lo, their y rising
  double lowest, highest;              ///< [m]
  double cell;                         ///< wider than asked for where the survey is large [m]
};

/// Wider than asked for where the survey within the extent is large [m].
[[nodiscard]] double panel_width(const GroundHeights& ground, const FloorExtent& extent);

/// Panels of two triangles each, which share their corners to the last digit, also with a floor
/// beside it of the same cell. Beyond the survey they grow with the distance from it.
[[nodiscard]] SurveyedFloor surveyed_floor(const GroundHeights& ground, FloorExtent extent);

/// Between an edge of ground that lies on the left from a to b, and a level floor at z = `foot` on
/// the right: it looks at that floor where the ground is higher, away from it where it is lower.
void add_wall(std::vector<StlTriangle>& triangles, const Vec3& a, const Vec3& b, double foot);

}  // namespace muckpile
