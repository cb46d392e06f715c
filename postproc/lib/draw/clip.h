// SPDX-License-Identifier: GPL-2.0-or-later
// Cuts a convex polygon to a rectangle.
// Scope: plane geometry; what lies wholly outside leaves nothing.
#pragma once

#include <vector>

#include "draw/axes.h"

namespace muckpile {

/// The part of a convex polygon inside the ranges, in the same sense; empty if there is none.
[[nodiscard]] std::vector<Vec2> clipped(std::vector<Vec2> polygon, const AxisRange& x,
                                        const AxisRange& y);

}  // namespace muckpile
