// SPDX-License-Identifier: GPL-2.0-or-later
// Outlines of what pieces of a plan cover together.
// Scope: pieces that touch and do not overlap; corners nearer than 1e-6 m are one.
#pragma once

#include <vector>

#include "geometry/shape/polygon.h"

namespace muckpile {

// Rings, counter-clockwise; one around a place that no piece covers runs clockwise. Where two
// pieces meet at a corner only, each has a ring.
std::vector<Polygon> outlines_of(const std::vector<Polygon>& pieces);

}  // namespace muckpile
