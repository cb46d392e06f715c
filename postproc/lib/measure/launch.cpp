// SPDX-License-Identifier: GPL-2.0-or-later
// How the surface over a charge goes up and outward, ring by ring of where its rock started.
// Scope: see the header.
#include "measure/launch.h"

#include <algorithm>
#include <cmath>

namespace muckpile {
namespace {

bool bounds_surface(const StartBlock& block) {
  constexpr double kTouch = 1e-3;  // of the block's size: far above the digits of the file
  return std::ranges::any_of(block.shape.vertices,
                             [&](const Vec3& p) { return p.z() >= -kTouch * block.size; });
}

}  // namespace

std::vector<SurfaceRing> surface_rings(const std::vector<StartBlock>& blocks, double width) {
  std::vector<SurfaceRing> rings;
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    if (!bounds_surface(blocks[b])) continue;
    const double radius = blocks[b].centroid.head<2>().norm();
    const auto at = static_cast<std::size_t>(radius / width);
    if (rings.size() <= at) rings.resize(at + 1, {0.0, 0.0, {}});
    rings[at].radius += blocks[b].mass * radius;
    rings[at].mass += blocks[b].mass;
    rings[at].blocks.push_back(b);
  }
  std::erase_if(rings, [](const SurfaceRing& ring) { return ring.blocks.empty(); });
  for (SurfaceRing& ring : rings) ring.radius /= ring.mass;
  return rings;
}

RingVelocity velocity_of(const SurfaceRing& ring, const std::vector<StartBlock>& blocks,
                         const Snapshot& snapshot) {
  RingVelocity mean{0.0, 0.0};
  for (const std::size_t b : ring.blocks) {
    const Eigen::Vector2d from_axis = blocks[b].centroid.head<2>();
    const Vec3& velocity = snapshot.states[b].velocity;
    const double share = blocks[b].mass / ring.mass, distance = from_axis.norm();
    if (distance > 0.0) mean.outward += share * from_axis.dot(velocity.head<2>()) / distance;
    mean.upward += share * velocity.z();
  }
  return mean;
}

}  // namespace muckpile
