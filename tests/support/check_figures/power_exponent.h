// SPDX-License-Identifier: GPL-2.0-or-later
// The exponent n of y = c x^n.
// Scope: least squares of ln y over ln x, all > 0.
#pragma once

#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace muckpile::check {

/// Of pairs x, y; nothing if all have one x.
[[nodiscard]] inline std::optional<double> power_exponent(
    const std::vector<std::pair<double, double>>& points) {
  const auto count = static_cast<double>(points.size());
  double x_mean = 0.0, y_mean = 0.0, xx = 0.0, xy = 0.0;
  for (const auto& [x, y] : points) {
    x_mean += std::log(x) / count;
    y_mean += std::log(y) / count;
  }
  for (const auto& [x, y] : points) {
    const double off = std::log(x) - x_mean;
    xx += off * off;
    xy += off * (std::log(y) - y_mean);
  }
  constexpr double kRoundOff = 1e-20;  // of squares of differences of logarithms
  if (xx <= kRoundOff) return std::nullopt;
  return xy / xx;
}

}  // namespace muckpile::check
