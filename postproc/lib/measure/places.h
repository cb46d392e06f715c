// SPDX-License-Identifier: GPL-2.0-or-later
// Where the blocks of a snapshot are, by shares of their number.
// Scope: centroids, one axis at a time.
#pragma once

#include <algorithm>
#include <vector>

#include "io/snapshot.h"

namespace muckpile {

// The coordinate that this share of the blocks lies below [m].
inline double place_of_share(const Snapshot& snapshot, Eigen::Index axis, double share) {
  std::vector<double> places;
  for (const BlockState& state : snapshot.states) places.push_back(state.centre[axis]);
  std::ranges::sort(places);
  return places[static_cast<size_t>(share * static_cast<double>(places.size() - 1))];
}

}  // namespace muckpile
