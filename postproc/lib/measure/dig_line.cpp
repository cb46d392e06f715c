// SPDX-License-Identifier: GPL-2.0-or-later
// What digging within given lines takes out of a pile.
// Scope: see the header.
#include "measure/dig_line.h"

namespace muckpile {

DigResult dig(const std::vector<OrePolygon>& polygons, const std::vector<StartBlock>& blocks,
              const Snapshot& last, const std::vector<char>& moved,
              const std::vector<double>& ore_share) {
  DigResult result;
  result.of_polygon.resize(polygons.size());
  for (size_t b = 0; b < blocks.size(); ++b) {
    const double mass = blocks[b].mass, ore = ore_share[b] * mass;
    result.ore += ore;
    if (moved[b] == 0) {
      result.ore_unbroken += ore;
      continue;
    }
    const auto add = [&](DugRock& to) {
      to.rock += mass;
      to.ore += ore;
    };
    bool is_dug = false;
    for (size_t k = 0; k < polygons.size(); ++k) {
      if (!polygons[k].contains(last.states[b].centre)) continue;
      add(result.of_polygon[k]);
      is_dug = true;
    }
    if (is_dug) add(result.all);
  }
  return result;
}

}  // namespace muckpile
