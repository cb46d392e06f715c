// SPDX-License-Identifier: GPL-2.0-or-later
// Lines of equal value between scattered points of a plane.
// Scope: values are linear over the triangles of a Delaunay triangulation; nothing outside the
// points' convex hull.
#pragma once

#include <array>
#include <utility>
#include <vector>

#include "measure/scan_polygon.h"

namespace muckpile {

using Triangle = std::array<size_t, 3>;

// Empty if there are fewer than three points or all lie on a line.
std::vector<Triangle> triangulate(const std::vector<Vec2>& points);

// Pieces of the line on which the value is `level`, one per triangle that it crosses.
std::vector<std::pair<Vec2, Vec2>> contour(const std::vector<Vec2>& points,
                                           const std::vector<double>& values,
                                           const std::vector<Triangle>& triangles, double level);

}  // namespace muckpile
