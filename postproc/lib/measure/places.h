// SPDX-License-Identifier: GPL-2.0-or-later
// Where the blocks of a snapshot are, by shares of their number.
// Scope: centroids, one axis at a time.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "io/snapshot.h"

namespace muckpile {

// The value that this share of them lies below; there must be one at least.
inline double value_of_share(std::vector<double> values, double share) {
  const auto place =
      values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::ranges::nth_element(values, place);
  return *place;
}

// The coordinate that this share of the blocks lies below [m].
inline double place_of_share(const Snapshot& snapshot, Eigen::Index axis, double share) {
  std::vector<double> places;
  for (const BlockState& state : snapshot.states) places.push_back(state.centre[axis]);
  return value_of_share(std::move(places), share);
}

}  // namespace muckpile
