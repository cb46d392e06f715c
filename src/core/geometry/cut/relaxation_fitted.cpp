// SPDX-License-Identifier: GPL-2.0-or-later
// Images behind fitted surfaces, once the seeds stand: no cell sticks out, and faces lie on the
// surface in the mean.
// Scope: serial, in the order of the seeds.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "geometry/cut/relaxation.h"
#include "geometry/shape/face_samples.h"

namespace muckpile {
namespace {

constexpr double kNearest = 0.05;  // [block sizes] from a seed to its plane

/// The corner that lies farthest out of a surface.
struct Leak {
  Vec3 corner = Vec3::Zero();
  double height = 0.0;  // [m]
};

Leak leak_of(const Polyhedron& shape, const FittedSurface& surface) {
  Leak worst;
  for (const Vec3& corner : shape.vertices) {
    const double height = surface.height(corner);
    if (height > worst.height) worst = {corner, height};
  }
  return worst;
}

}  // namespace

/// A cell that sticks out between its planes gets one more, at the surface below its highest
/// corner.
void Relaxation::stop_leaks(Images& images) const {
  constexpr double kMost = 0.25, kReach = 2.0;  // [block sizes] of a corner, of seeds looked at
  const std::vector<FittedSurface>& surfaces = options_.region.fitted;
  const std::vector<Vec3> points = points_with(images);
  CellCutter cutter(points, options_.lo, options_.hi, bounds_);
  Polyhedron shape;
  std::vector<int> behind;
  for (std::size_t n = 0; n < seeds_.size(); ++n) {
    const Vec3& seed = seeds_[n];
    const double size = ground_.size(seed);
    for (std::size_t s = 0; s < surfaces.size(); ++s) {
      if (ring_seed(n) || (surfaces[s].closest(seed) - seed).norm() > kReach * size) continue;
      (void)cut(cutter, n, {});
      cutter.extract(shape, behind);
      const Leak leak = leak_of(shape, surfaces[s]);
      if (leak.height < kMost * size) continue;
      const Vec3 on_surface = surfaces[s].closest(leak.corner);
      const Vec3 out = (leak.corner - on_surface).normalized();
      const double away = std::max(out.dot(on_surface - seed), kNearest * size);
      const Vec3 image = seed + 2.0 * away * out;
      if (options_.region.inside(image)) continue;
      images.points.push_back(image);
      images.face_codes.push_back(kFreeFace);
      images.fitted.push_back({images.points.size() - 1, n, s});
    }
  }
}

/// Moves the image behind a fitted surface until the block's face lies on that surface in the mean:
/// so many faces, each a plane, leave the rock its volume.
void Relaxation::fit_images(Images& images) const {
  constexpr double kMost = 0.25;  // [block sizes] of a step
  const std::vector<Vec3> points = points_with(images);
  CellCutter cutter(points, options_.lo, options_.hi, bounds_);
  Polyhedron shape;
  const std::vector<VoidWall> walls = own_walls();
  std::vector<int> behind;
  for (const auto& [number, n, surface] : images.fitted) {
    if (!cut(cutter, n, walls[n])) continue;
    cutter.extract(shape, behind);
    const auto face = std::ranges::find(behind, static_cast<int>(seeds_.size() + number));
    if (face == behind.end()) continue;
    const double off = mean_over_face(shape, static_cast<std::size_t>(face - behind.begin()),
                                      options_.region.fitted[surface].height);
    const Vec3& seed = seeds_[n];
    Vec3& image = images.points[number];
    const double size = ground_.size(seed), away = 0.5 * (image - seed).norm();
    const double next =
        std::max(away - std::clamp(off, -kMost * size, kMost * size), kNearest * size);
    image = seed + next / away * (image - seed);
  }
}

void Relaxation::bound_by_fitted(Images& images) const {
  constexpr int kRounds = 3;
  if (options_.region.fitted.empty()) return;
  for (int round = 0; round < kRounds; ++round) {
    stop_leaks(images);
    fit_images(images);
  }
}

}  // namespace muckpile
