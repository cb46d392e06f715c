// SPDX-License-Identifier: GPL-2.0-or-later
// Sieve size of a piece: the side of the smallest square opening through which it passes straight.
// Scope: of the convex hull of its points; a search, so the exact value or slightly more.
#pragma once

#include <vector>

#include "io/blocks_file.h"
#include "math/types.h"

namespace muckpile {

// The least max(w(u), w(v)) over u at right angles to v, where w is the width of the points along a
// direction [m]. `starts` are the directions from which the search for u begins.
double sieve_size(const std::vector<Vec3>& points, const std::vector<Vec3>& starts);

// Of one block, from the normals of its faces [m].
double sieve_size(const StartBlock& block);

// Evenly over half of the sphere, as starts for a piece of many blocks.
std::vector<Vec3> spread_directions(int count);

// The points that lie farthest along so many spread directions: enough for widths of a piece of
// many blocks.
std::vector<Vec3> outermost(const std::vector<Vec3>& points, int directions);

}  // namespace muckpile
