// SPDX-License-Identifier: GPL-2.0-or-later
// Convex polygons in a plane: area, overlap, and the way from space to the plane and back.
// Scope: counter-clockwise corners about the plane's normal; lengths in metres.
#pragma once

#include <vector>

#include "math/types.h"

namespace muckpile {

using Vec2 = Eigen::Vector2d;
using Polygon = std::vector<Vec2>;

[[nodiscard]] double area_of(const Polygon& polygon);  // [m2]

/// What two convex polygons share; may have fewer than three corners.
[[nodiscard]] Polygon overlap(Polygon polygon, const Polygon& other);

/// The rest of a convex polygon beside another, in convex pieces; some may have no area.
[[nodiscard]] std::vector<Polygon> without(const Polygon& polygon, const Polygon& other);

/// Axes in a plane.
struct PlaneFrame {
  Vec3 origin, normal, first, second;
  /// The normal may have any length but 0.
  PlaneFrame(const Vec3& point, const Vec3& along);
  [[nodiscard]] Vec2 flat(const Vec3& p) const {
    return {first.dot(p - origin), second.dot(p - origin)};
  }
  [[nodiscard]] Vec3 space(const Vec2& p) const { return origin + p.x() * first + p.y() * second; }
};

}  // namespace muckpile
