// SPDX-License-Identifier: GPL-2.0-or-later
// Delaunay triangles of points in plan.
// Scope: points one by one, edges flipped (Lawson 1977); places that are the same to rounding count
// once.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "geometry/shape/polygon.h"

namespace muckpile {

/// Corners of the triangles, counter-clockwise, in the numbers of `points`. Empty where the points
/// lie on one line.
[[nodiscard]] std::vector<std::array<std::size_t, 3>> delaunay(const std::vector<Vec2>& points);

}  // namespace muckpile
