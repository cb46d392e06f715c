// SPDX-License-Identifier: GPL-2.0-or-later
// Whether two plane polygons in space meet along an edge or in a point only.
// Scope: their edges need not have the same ends; overlaps of faces are not looked for.
#pragma once

#include <span>

#include "math/types.h"

namespace muckpile {

/// Length on which edges of two polygons lie on each other, to within a ten-thousandth of `size`
/// [m].
[[nodiscard]] double shared_edge_length(std::span<const Vec3> a, std::span<const Vec3> b,
                                        double size);

/// Whether that is more than a hundredth of `size` [m]: less is a corner, to rounding and to the
/// slivers of a cut.
[[nodiscard]] bool share_an_edge(std::span<const Vec3> a, std::span<const Vec3> b, double size);

}  // namespace muckpile
