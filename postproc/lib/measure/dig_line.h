// SPDX-License-Identifier: GPL-2.0-or-later
// What digging within given lines takes out of a pile: ore, other rock, and the ore that is lost.
// Scope: blocks by their centroids at the end; of a block that is ore in part, that share.
#pragma once

#include <string>
#include <vector>

#include "io/ore_polygons.h"
#include "io/snapshot.h"

namespace muckpile {

struct DugRock {
  double rock = 0.0;  // broken-out rock within [kg]
  double ore = 0.0;   // of it [kg]
  // Share of other rock; NaN where nothing is dug.
  [[nodiscard]] double dilution() const { return (rock - ore) / rock; }
};

struct DigResult {
  std::vector<DugRock> of_polygon;                                  // in the order of the polygons
  DugRock all;                                                      // within any of them
  double ore = 0.0;                                                 // in all of the run's rock [kg]
  double ore_unbroken = 0.0;                                        // of it not broken out [kg]
  [[nodiscard]] double loss() const { return ore - all.ore; }       // [kg]
  [[nodiscard]] double loss_share() const { return loss() / ore; }  // NaN where there is no ore
};

// `polygons` are of the pile, in the run's axes; one bounded in height is dug between its levels.
// Rock that was not broken out is not dug. `ore_share` is each block's, 0 to 1.
DigResult dig(const std::vector<OrePolygon>& polygons, const std::vector<StartBlock>& blocks,
              const Snapshot& last, const std::vector<char>& moved,
              const std::vector<double>& ore_share);

}  // namespace muckpile
