// SPDX-License-Identifier: GPL-2.0-or-later
// The contact spheres of a block: so many of such a size that blocks stay out of each other.
// Scope: convex polyhedra in the start configuration; lengths in metres.
#pragma once

#include <limits>
#include <vector>

#include "geometry/spheres/sphere_filling.h"

namespace muckpile {

struct SphereRule {
  int count = 8;        ///< of a block's spheres at least (fill_with_spheres)
  double growth = 1.0;  ///< radius over that of spheres inside the block
  /// No place of a block's surface lies farther from its spheres, as long as it has fewer than
  /// kMostSpheres: a sphere of that radius cannot enter the block with its centre [m].
  double surface_gap = std::numeric_limits<double>::infinity();
};
inline constexpr int kMostSpheres = 64;

/// Those of fill_with_spheres(), grown, where they leave no larger gap; else the first of them and
/// as many as the gap asks for, each as large as it may be and inside the block before it is grown.
/// Gaps are looked for at places half the gap apart at most, or a hundredth of the block. Same
/// input, same spheres.
[[nodiscard]] std::vector<Sphere> contact_spheres(const Polyhedron& shape, const Vec3& centroid,
                                                  const SphereRule& rule);

}  // namespace muckpile
