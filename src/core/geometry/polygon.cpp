// SPDX-License-Identifier: GPL-2.0-or-later
// Convex polygons in a plane.
// Scope: see the header.
#include "geometry/polygon.h"

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

}  // namespace

double area_of(const Polygon& polygon) {
  double twice = 0.0;
  for (std::size_t k = 1; k + 1 < polygon.size(); ++k)
    twice += cross(polygon[k] - polygon[0], polygon[k + 1] - polygon[0]);
  return 0.5 * twice;
}

Polygon overlap(Polygon polygon, const Polygon& other) {
  for (std::size_t k = 0; k < other.size() && polygon.size() > 2; ++k)
    polygon = left_of(polygon, other[k], other[(k + 1) % other.size()]);
  return polygon;
}

PlaneFrame::PlaneFrame(const Vec3& point, const Vec3& along)
    : origin(point),
      normal(along.normalized()),
      first(normal.unitOrthogonal()),
      second(normal.cross(first)) {}

}  // namespace muckpile
