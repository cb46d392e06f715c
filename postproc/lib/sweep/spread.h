// SPDX-License-Identifier: GPL-2.0-or-later
// How a figure scatters over runs that differ in their seed only.
// Scope: any number of values, of which one or two tell little.
#pragma once

#include <cstddef>
#include <vector>

namespace muckpile {

struct Spread {
  size_t count;
  double mean, deviation;  // deviation of one value, by count - 1; NaN of a single value
  double least, p10, p50, p90, largest;
};

// `values` holds one at least.
[[nodiscard]] Spread spread_of(std::vector<double> values);

// The value that a share of them does not exceed. Between two values, which stand for shares
// k/(n-1), it is linear (Hyndman & Fan 1996, definition 7). `rising` holds one at least.
[[nodiscard]] double quantile(const std::vector<double>& rising, double share);

}  // namespace muckpile
