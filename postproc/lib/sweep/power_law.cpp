// SPDX-License-Identifier: GPL-2.0-or-later
// The exponent of a power law with a factor of its own for each group.
// Scope: see the header.
#include "sweep/power_law.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace muckpile {
namespace {

struct Sums {
  double count = 0.0, x = 0.0, y = 0.0;  // of ln x, ln y
};

}  // namespace

std::optional<PowerLaw> fit_power_law(const std::vector<PowerPoint>& points) {
  std::set<double> places;
  std::map<size_t, Sums> groups;
  for (const PowerPoint& point : points) {
    places.insert(point.x);
    Sums& sums = groups[point.group];
    sums.count += 1.0;
    sums.x += std::log(point.x);
    sums.y += std::log(point.y);
  }
  // About the means of its group each point has the same law without a factor.
  double xx = 0.0, xy = 0.0, yy = 0.0;
  for (const PowerPoint& point : points) {
    const Sums& sums = groups.at(point.group);
    const double x = std::log(point.x) - sums.x / sums.count;
    const double y = std::log(point.y) - sums.y / sums.count;
    xx += x * x;
    xy += x * y;
    yy += y * y;
  }
  constexpr double kRoundOff = 1e-20;  // of squared logarithms
  if (places.size() < 3 || !(xx > kRoundOff)) return std::nullopt;
  const double count = static_cast<double>(points.size()), exponent = xy / xx;
  const double squares = std::max(0.0, yy - exponent * xy);
  PowerLaw law{exponent, std::nullopt, std::sqrt(squares / count)};
  const double spare = count - static_cast<double>(groups.size()) - 1.0;
  if (spare > 0.0) law.error = std::sqrt(squares / spare / xx);
  return law;
}

}  // namespace muckpile
