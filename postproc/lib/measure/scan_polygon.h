// SPDX-License-Identifier: GPL-2.0-or-later
// Which cells of a grid have their centre inside a polygon: the one rasteriser behind columns,
// pictures and shadows. Scope: even-odd rule; a centre exactly on an edge shared by two polygons
// belongs to one of them.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

namespace muckpile {

using Vec2 = Eigen::Vector2d;

// First cell whose centre lies at or after coordinate `c`, in cell units, within [0, limit].
inline int first_cell(double c, int limit) {
  return static_cast<int>(std::clamp(std::ceil(c - 0.5), 0.0, static_cast<double>(limit)));
}

// Calls span(row, begin, end) for each run of cells [begin, end) whose centres are inside. Points
// are in cell units: cell (i, j) covers [i, i+1) x [j, j+1). `crossings` is scratch space that a
// caller may keep between calls.
template <class Span>
void scan_polygon(std::span<const Vec2> points, int width, int height,
                  std::vector<double>& crossings, Span&& span) {
  if (points.size() < 3) return;
  const auto [low, high] =
      std::ranges::minmax_element(points, {}, [](const Vec2& p) { return p.y(); });
  const int first_row = first_cell(low->y(), height);
  const int last_row = first_cell(high->y(), height);
  for (int row = first_row; row < last_row; ++row) {
    const double y = row + 0.5;
    crossings.clear();
    for (size_t i = 0, j = points.size() - 1; i < points.size(); j = i++) {
      const Vec2 &a = points[j], &b = points[i];
      if ((a.y() <= y) == (b.y() <= y)) continue;
      // From the lower end, so that both polygons at a shared edge find the same crossing to the
      // last bit.
      const Vec2 &lo = a.y() < b.y() ? a : b, &hi = a.y() < b.y() ? b : a;
      crossings.push_back(lo.x() + (y - lo.y()) / (hi.y() - lo.y()) * (hi.x() - lo.x()));
    }
    std::ranges::sort(crossings);
    for (size_t k = 0; k + 1 < crossings.size(); k += 2) {
      const int begin = first_cell(crossings[k], width), end = first_cell(crossings[k + 1], width);
      if (begin < end) span(row, begin, end);
    }
  }
}

}  // namespace muckpile
