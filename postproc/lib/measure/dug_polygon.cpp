// SPDX-License-Identifier: GPL-2.0-or-later
// A polygon of ore in the pile.
// Scope: see the header.
#include "measure/dug_polygon.h"

namespace muckpile {

DugPolygon dug_polygon(const OrePolygon& polygon, const std::vector<size_t>& chosen,
                       const std::vector<StartBlock>& blocks, const Snapshot& last,
                       const std::vector<char>& moved) {
  DugPolygon dug{movement_of(chosen, blocks, last, moved), polygon.corners, 0.0, 0.0};
  for (Vec2& corner : dug.outline) corner += dug.rock.displacement().head<2>();
  const OrePolygon carried{polygon.name, dug.outline, 0.0, 0.0};
  std::vector<char> is_ore(blocks.size(), 0);
  for (const size_t b : chosen) is_ore[b] = 1;
  double ore = 0.0, dug_ore = 0.0, dug_waste = 0.0;  // [kg]
  for (size_t b = 0; b < blocks.size(); ++b) {
    if (!carried.contains(Vec2(last.states[b].centre.head<2>()))) continue;
    if (is_ore[b] != 0) ore += blocks[b].mass;
    if (moved[b] != 0) (is_ore[b] != 0 ? dug_ore : dug_waste) += blocks[b].mass;
  }
  dug.recovered = ore / dug.rock.mass;
  dug.dilution = dug_waste / (dug_ore + dug_waste);
  return dug;
}

}  // namespace muckpile
