// SPDX-License-Identifier: GPL-2.0-or-later
// The power trough.
// Scope: see the header. What would stand in a valley if water filled it is told by the highest
// samples to both sides of each.
#include "measure/trough.h"

#include <algorithm>
#include <cstddef>
#include <limits>

namespace muckpile {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

// The highest sample up to and with each, from the front of the list.
std::vector<double> highest_so_far(std::vector<double> z) {
  for (size_t i = 1; i < z.size(); ++i) z[i] = std::max(z[i], z[i - 1]);
  return z;
}

// Where the straight line between two samples has a height.
double crossing(const std::vector<double>& x, const std::vector<double>& z, size_t from, size_t to,
                double height) {
  return x[from] + (height - z[from]) / (z[to] - z[from]) * (x[to] - x[from]);
}

// Area below `height` between two samples, of which one may lie above it.
double area_below(const std::vector<double>& x, const std::vector<double>& z, size_t i,
                  double height) {
  const double dx = x[i + 1] - x[i], a = height - z[i], b = height - z[i + 1];
  if (a >= 0.0 && b >= 0.0) return 0.5 * (a + b) * dx;
  if (a <= 0.0 && b <= 0.0) return 0.0;
  const double under = std::max(a, b), over = -std::min(a, b);
  return 0.5 * under * dx * under / (under + over);
}

}  // namespace

Trough deepest_trough(const std::vector<double>& x, const std::vector<double>& z, double least) {
  Trough none{kNan, kNan, kNan, 0.0, 0.0, 0.0, kNan, kNan, kNan};
  if (z.size() < 3) return none;
  const std::vector<double> behind = highest_so_far(z);
  std::vector<double> ahead = highest_so_far({z.rbegin(), z.rend()});
  std::ranges::reverse(ahead);
  const auto rim_at = [&](size_t i) { return std::min(behind[i], ahead[i]); };
  size_t lowest = 0;
  for (size_t i = 1; i < z.size(); ++i)
    if (rim_at(i) - z[i] > rim_at(lowest) - z[lowest]) lowest = i;
  Trough trough = none;
  trough.depth = rim_at(lowest) - z[lowest];
  if (!(trough.depth > 0.0) || trough.depth < least) return none;
  trough.x = x[lowest];
  trough.z = z[lowest];
  trough.rim = rim_at(lowest);
  trough.crest = ahead[lowest];
  size_t begin = lowest, end = lowest;  // the samples on its rims
  while (z[begin] < trough.rim) --begin;
  while (z[end] < trough.rim) ++end;
  trough.back = crossing(x, z, begin, begin + 1, trough.rim);
  trough.front = crossing(x, z, end, end - 1, trough.rim);
  trough.width = trough.front - trough.back;
  for (size_t i = begin; i < end; ++i) trough.area += area_below(x, z, i, trough.rim);
  return trough;
}

Trough deepest_trough(const std::vector<double>& x, const std::vector<double>& z,
                      const std::vector<double>& floor, double least) {
  const auto ground = [&](size_t i) { return z[i] - floor[i] <= least; };
  size_t begin = 0, end = z.size();
  while (end > 0 && ground(end - 1)) --end;
  while (begin < end && ground(begin)) ++begin;
  if (begin > 0) --begin;  // the toe
  if (end < z.size()) ++end;
  const auto part = [=](const std::vector<double>& all) {
    return std::vector<double>(all.begin() + static_cast<std::ptrdiff_t>(begin),
                               all.begin() + static_cast<std::ptrdiff_t>(end));
  };
  return deepest_trough(part(x), part(z), least);
}

}  // namespace muckpile
