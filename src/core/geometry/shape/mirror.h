// SPDX-License-Identifier: GPL-2.0-or-later
// Image seeds behind the surfaces of holes and region: what keeps blocks out of the air.
// Scope: the plane halfway between a seed and its image touches the surface at the closest point.
// A hole is convex, so that plane never cuts into it; blocks stay cells of one Voronoi diagram.
#pragma once

#include <cstddef>
#include <vector>

#include "geometry/cut/ground.h"

namespace muckpile {

struct Images {
  std::vector<Vec3> points;     // [m]
  std::vector<int> face_codes;  // kFreeFace or hole_face(h) for a block's face against the image
  struct Fitted {
    std::size_t image, seed, surface;
  };
  std::vector<Fitted> fitted;  // those behind planes of fitted surfaces
};

// `holes` are the options' holes with the radii that are mirrored at now; none at a radius of 0.
[[nodiscard]] Images mirror_seeds(const std::vector<Vec3>& seeds, const std::vector<Hole>& holes,
                                  const RegionQuery& region, const Ground& ground);

}  // namespace muckpile
