// SPDX-License-Identifier: GPL-2.0-or-later
// Convex polygons in a plane.
// Scope: see the header.
#include "geometry/shape/polygon.h"

#include <cmath>
#include <utility>

namespace muckpile {
namespace {

double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Part of a polygon to the left of the line from a to b (Sutherland & Hodgman 1974).
Polygon left_of(const Polygon& polygon, const Vec2& a, const Vec2& b) {
  Polygon kept;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vec2 &p = polygon[k], &q = polygon[(k + 1) % polygon.size()];
    const double at_p = cross(b - a, p - a), at_q = cross(b - a, q - a);
    if (at_p >= 0.0) kept.push_back(p);
    if ((at_p >= 0.0) != (at_q >= 0.0)) kept.push_back(p + at_p / (at_p - at_q) * (q - p));
  }
  return kept;
}

/// Sides of a polygon, without those of rounding's length: they have no direction.
std::vector<std::pair<Vec2, Vec2>> sides_of(const Polygon& polygon) {
  constexpr double kRounding = 1e-9;  // of the polygon's size
  const double shortest = kRounding * std::sqrt(std::abs(area_of(polygon)));
  std::vector<std::pair<Vec2, Vec2>> sides;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vec2 &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
    if ((b - a).norm() > shortest) sides.emplace_back(a, b);
  }
  return sides;
}

}  // namespace

double area_of(const Polygon& polygon) {
  double twice = 0.0;
  for (std::size_t k = 1; k + 1 < polygon.size(); ++k)
    twice += cross(polygon[k] - polygon[0], polygon[k + 1] - polygon[0]);
  return 0.5 * twice;
}

Polygon overlap(Polygon polygon, const Polygon& other) {
  for (const auto& [a, b] : sides_of(other)) polygon = left_of(polygon, a, b);
  return polygon;
}

std::vector<Polygon> without(const Polygon& polygon, const Polygon& other) {
  std::vector<Polygon> pieces;
  Polygon rest = polygon;  // to the left of the sides so far
  for (const auto& [a, b] : sides_of(other)) {
    Polygon right = left_of(rest, b, a);
    if (right.size() > 2) pieces.push_back(std::move(right));
    rest = left_of(rest, a, b);
  }
  return pieces;
}

PlaneFrame::PlaneFrame(const Vec3& point, const Vec3& along)
    : origin(point),
      normal(along.normalized()),
      first(normal.unitOrthogonal()),
      second(normal.cross(first)) {}

}  // namespace muckpile
