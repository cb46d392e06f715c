// SPDX-License-Identifier: GPL-2.0-or-later
// Cuts a convex polygon to a rectangle.
// Scope: see the header.
#include "draw/clip.h"

namespace muckpile {
namespace {

/// Keeps what lies on the side of `limit` along `axis` where sign x coordinate is smaller.
/// Sutherland and Hodgman, Commun. ACM 17 (1974) 32: walks the edges, adds each crossing.
void cut(std::vector<Vec2>& polygon, int axis, double limit, double sign) {
  std::vector<Vec2> kept;
  for (size_t k = 0; k < polygon.size(); ++k) {
    const Vec2 &from = polygon[k], &to = polygon[(k + 1) % polygon.size()];
    const double inside_from = sign * (limit - from[axis]), inside_to = sign * (limit - to[axis]);
    if (inside_from >= 0.0) kept.push_back(from);
    if ((inside_from < 0.0) == (inside_to < 0.0)) continue;
    Vec2 crossing = from + inside_from / (inside_from - inside_to) * (to - from);
    crossing[axis] = limit;
    kept.push_back(crossing);
  }
  polygon = std::move(kept);
}

}  // namespace

std::vector<Vec2> clipped(std::vector<Vec2> polygon, const AxisRange& x, const AxisRange& y) {
  cut(polygon, 0, x.low, -1.0);
  cut(polygon, 0, x.high, 1.0);
  cut(polygon, 1, y.low, -1.0);
  cut(polygon, 1, y.high, 1.0);
  if (polygon.size() < 3) polygon.clear();
  return polygon;
}

}  // namespace muckpile
