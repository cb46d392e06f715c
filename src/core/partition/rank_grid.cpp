// SPDX-License-Identifier: GPL-2.0-or-later
// Slabs along x and y: the largest divisor of the ranks that fits along y.
// Scope: see the header.
#include "partition/rank_grid.h"

namespace muckpile {

RankGrid rank_grid(int ranks, double width_y, double thinnest) {
  int slabs = ranks;
  while (slabs > 1 && (ranks % slabs != 0 || width_y < slabs * thinnest)) --slabs;
  return {ranks / slabs, slabs};
}

}  // namespace muckpile
