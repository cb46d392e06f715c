// SPDX-License-Identifier: GPL-2.0-or-later
// Touches of spheres and a plane.
// Scope: see the header.
#include "wall/wall_plane.h"

#include <algorithm>
#include <limits>

namespace muckpile {

WallPlane::WallPlane(const Vec3& point, const Vec3& normal)
    : point_(point), normal_(normal.normalized()) {}

double WallPlane::distance(const Vec3& place, double reach, std::vector<std::size_t>& parts) const {
  parts.clear();
  const double height = normal_.dot(place - point_);
  return height <= reach ? height : std::numeric_limits<double>::infinity();
}

void WallPlane::find_touches(const Vec3& centre, double radius, std::span<const std::size_t>,
                             WallTouches& touches) const {
  touches.clear();
  const double height = normal_.dot(centre - point_);
  if (height < radius) touches.add({normal_, radius - height});
}

double WallPlane::depth(const Vec3& place) const {
  return std::max(0.0, normal_.dot(point_ - place));
}

}  // namespace muckpile
