// SPDX-License-Identifier: GPL-2.0-or-later
// How well spheres stand for the shape of their block.
// Scope: convex polyhedra; sampled, good to about 1 %.
#pragma once

#include <vector>

#include "geometry/spheres/sphere_filling.h"

namespace muckpile {

struct FillingQuality {
  double coverage = 0.0;           ///< share of the block's volume that lies in a sphere [-]
  double surface_deviation = 0.0;  ///< mean distance of the block's surface from that of the
                                   ///< spheres, over V^(1/3) [-]
};

/// The same points for the same shape: some 20^3 in its bounding box, some 20 a side of each face.
[[nodiscard]] FillingQuality filling_quality(const Polyhedron& shape,
                                             const std::vector<Sphere>& spheres);

}  // namespace muckpile
