// SPDX-License-Identifier: GPL-2.0-or-later
// How many slabs of rock along x and along y, for a number of ranks.
// Scope: a pure function; the slabs are as wide as the rock allows, before borders move.
#pragma once

namespace muckpile {

struct RankGrid {
  int along_x = 1, along_y = 1;
};

/// As many slabs along y as divide `ranks` and leave each at least `thinnest` [m] of `width_y` [m];
/// the rest along x.
[[nodiscard]] RankGrid rank_grid(int ranks, double width_y, double thinnest);

}  // namespace muckpile
