// SPDX-License-Identifier: GPL-2.0-or-later
// A polygon of ore in the pile: its outline carried along, and what digging within it would give.
// Scope: the outline moves as its rock does on average, without turning or stretching; in plan.
#pragma once

#include <vector>

#include "io/ore_polygons.h"
#include "measure/movement.h"

namespace muckpile {

struct DugPolygon {
  RockMovement rock;          // that started in the polygon
  std::vector<Vec2> outline;  // the corners, moved by the rock's mean displacement [m]
  double recovered;           // share of the rock's mass that ended within the outline
  double dilution;            // share of other rock in the broken-out rock within it; NaN if none
};

// `chosen` are the blocks that started in the polygon, one at least.
DugPolygon dug_polygon(const OrePolygon& polygon, const std::vector<size_t>& chosen,
                       const std::vector<StartBlock>& blocks, const Snapshot& last,
                       const std::vector<char>& moved);

}  // namespace muckpile
