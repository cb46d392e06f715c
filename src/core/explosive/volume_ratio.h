// SPDX-License-Identifier: GPL-2.0-or-later
// Where on an expansion something ceases to hold.
// Scope: what falls monotonically with the volume of the products.
#pragma once

namespace muckpile {

/// Volume ratio from `start` on at which `above(ratio)` becomes false, to rounding; it does so
/// once, and within finite volume.
template <class Above>
double volume_ratio_where(double start, const Above& above) {
  if (!above(start)) return start;
  double low = start, high = 2.0 * start;
  while (above(high)) high *= 2.0;
  for (int halving = 0; halving < 100; ++halving) {
    const double middle = 0.5 * (low + high);
    (above(middle) ? low : high) = middle;
  }
  return high;
}

}  // namespace muckpile
