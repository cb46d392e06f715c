// SPDX-License-Identifier: GPL-2.0-or-later
// Image seeds behind the surfaces of holes and region: what keeps blocks out of the air.
// Scope: serial, in the order of the seeds.
#include "geometry/shape/mirror.h"

#include <algorithm>
#include <cstddef>

#include "geometry/holes/hole_surface.h"

namespace muckpile {
namespace {

// Seeds that far from a surface are mirrored [block sizes]. Images inside a convex hole never hurt.
// Those behind an inner edge of the region do, where they come close to its other side: there only
// the first layer of blocks is mirrored.
constexpr double kHoleReach = 2.0;
constexpr double kRegionReach = 1.0;

// An image deeper than the axis would come out on the other side and push blocks off there, so
// the depth ends at the axis: the plane then stays farther out and the hole is still kept free.
void mirror_at_hole(const Vec3& seed, const Hole& hole, int number, double reach, Images& images) {
  if (!(hole.radius > 0.0)) return;
  const Vec3 surface = closest_on_hole(hole, seed);
  const double distance = (seed - surface).norm();
  if (distance > reach || !(distance > 0.0)) return;
  const double depth = std::min({distance, hole.radius, 0.5 * hole_length(hole)});
  images.points.push_back(surface + depth / distance * (surface - seed));
  images.face_codes.push_back(hole_face(number));
}

/// False behind a thin slit of air: no image, no harm.
bool mirror_at_surface(const Vec3& seed, const Vec3& surface, const RegionQuery& region,
                       Images& images) {
  const Vec3 image = 2.0 * surface - seed;
  if (region.inside(image)) return false;
  images.points.push_back(image);
  images.face_codes.push_back(kFreeFace);
  return true;
}

void mirror_at_fitted(const Vec3& seed, std::size_t number, double reach, const RegionQuery& region,
                      Images& images) {
  for (std::size_t s = 0; s < region.fitted.size(); ++s) {
    for (const Vec3& foot : region.fitted[s].feet(seed, reach)) {
      if (mirror_at_surface(seed, foot, region, images))
        images.fitted.push_back({images.points.size() - 1, number, s});
    }
  }
}

}  // namespace

Images mirror_seeds(const std::vector<Vec3>& seeds, const std::vector<Hole>& holes,
                    const RegionQuery& region, const Ground& ground) {
  Images images;
  std::vector<int> near;
  for (std::size_t n = 0; n < seeds.size(); ++n) {
    const Vec3& seed = seeds[n];
    const double size = ground.size(seed);
    ground.holes_near(seed, kHoleReach * size, near);
    for (const int h : near) {
      mirror_at_hole(seed, holes[static_cast<std::size_t>(h)], h, kHoleReach * size, images);
    }
    if (!region.surface_points) continue;
    for (const Vec3& surface : region.surface_points(seed, kRegionReach * size))
      (void)mirror_at_surface(seed, surface, region, images);
    mirror_at_fitted(seed, n, kRegionReach * size, region, images);
  }
  return images;
}

}  // namespace muckpile
