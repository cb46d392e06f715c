// SPDX-License-Identifier: GPL-2.0-or-later
// How a figure scatters over runs that differ in their seed only.
// Scope: see the header.
#include "sweep/spread.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace muckpile {

double quantile(const std::vector<double>& rising, double share) {
  const double place = share * static_cast<double>(rising.size() - 1);
  const auto below = static_cast<size_t>(place);
  const size_t above = std::min(below + 1, rising.size() - 1);
  return std::lerp(rising[below], rising[above], place - static_cast<double>(below));
}

Spread spread_of(std::vector<double> values) {
  std::ranges::sort(values);
  const auto count = static_cast<double>(values.size());
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) / count;
  double squares = 0.0;
  for (const double value : values) squares += (value - mean) * (value - mean);
  const double deviation = values.size() > 1 ? std::sqrt(squares / (count - 1.0))
                                             : std::numeric_limits<double>::quiet_NaN();
  return {values.size(),
          mean,
          deviation,
          values.front(),
          quantile(values, 0.1),
          quantile(values, 0.5),
          quantile(values, 0.9),
          values.back()};
}

}  // namespace muckpile
