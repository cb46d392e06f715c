// SPDX-License-Identifier: GPL-2.0-or-later
// Planes that part a cell into rock and what lies outside the region.
// Scope: see the header.
#include "geometry/cut/region_cutting.h"

#include <algorithm>
#include <utility>

namespace muckpile {

double reach_of(const ConvexCell& cell, const Vec3& middle) {
  double reach = 0.0;
  for (const Vec3& v : cell.shape.vertices) reach = std::max(reach, (v - middle).norm());
  return reach;
}

std::vector<Vec3> lookouts(const ConvexCell& cell, const Vec3& middle) {
  std::vector<Vec3> points{middle};
  for (const Vec3& v : cell.shape.vertices) {
    for (const double share : {0.3, 0.9}) points.push_back(middle + share * (v - middle));
  }
  return points;
}

namespace {

/// Whether the closest point moves along with a lookout that moves along the surface: it is not the
/// end of a smooth piece. On a flat piece it moves exactly as far.
bool moves_along(const RegionQuery& region, const Vec3& from, const Vec3& closest, const Vec3& by,
                 double cutoff, SurfaceKind kind) {
  const double allowed = (kind == SurfaceKind::flat ? 1e-6 : 0.5) * by.norm();
  for (const double sign : {1.0, -1.0}) {
    for (const Vec3& q : region.surface_points(from + sign * by, cutoff)) {
      if ((q - (closest + sign * by)).norm() < allowed) return true;
    }
  }
  return false;
}

}  // namespace

std::optional<CutPlane> surface_through(const RegionQuery& region, const ConvexCell& cell,
                                        SurfaceKind kind) {
  constexpr double kStep = 0.01, kTouching = 1e-9;  // of the cell's reach
  const Vec3 middle = centroid_of(cell);
  const double reach = reach_of(cell, middle), cutoff = 2.0 * reach;
  std::optional<CutPlane> best;
  double largest = 0.0;
  for (const Vec3& from : lookouts(cell, middle)) {
    for (const Vec3& closest : region.surface_points(from, cutoff)) {
      if ((closest - from).norm() < kTouching * reach) continue;
      const Vec3 normal = (closest - from).normalized(), first = normal.unitOrthogonal();
      const auto halves = divided(cell, closest, normal, 0);
      if (!halves) continue;
      if (region.inside(centroid_of(halves->below)) == region.inside(centroid_of(halves->above)))
        continue;
      const double smaller = std::min(volume_of(halves->below), volume_of(halves->above));
      if (smaller <= largest) continue;
      const double step = kStep * reach;
      if (!moves_along(region, from, closest, step * first, cutoff, kind) ||
          !moves_along(region, from, closest, step * normal.cross(first), cutoff, kind))
        continue;
      largest = smaller;
      best = CutPlane{closest, normal};
    }
  }
  return best;
}

bool is_far_outside(const RegionQuery& region, const ConvexCell& cell) {
  const Vec3 middle = centroid_of(cell);
  return !region.inside(middle) && region.surface_points(middle, reach_of(cell, middle)).empty();
}

}  // namespace muckpile
