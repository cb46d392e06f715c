// SPDX-License-Identifier: GPL-2.0-or-later
// Distances and closest points on the finite cylinder of a crushed zone.
// Scope: one hole at a time; lengths in metres.
#pragma once

#include <cstddef>
#include <vector>

#include "geometry/block_model.h"

namespace muckpile {

[[nodiscard]] double hole_length(const Hole& hole);  // [m]

// True inside the closed cylinder.
[[nodiscard]] bool inside_hole(const Hole& hole, const Vec3& point);

// Closest point of the cylinder's surface to a point outside it. For a point inside the cylinder
// the point itself is returned.
[[nodiscard]] Vec3 closest_on_hole(const Hole& hole, const Vec3& point);

// Part of the cylinder's volume where `is_ground(point)` holds [m3]; 32768-point quadrature, so
// exact when all of it is in the ground and good to about 1 % when a wall cuts it.
template <class Predicate>
[[nodiscard]] double cylinder_volume_where(const Hole& hole, Predicate is_ground);

// Equal-volume sample points of the cylinder, used by cylinder_volume_where.
[[nodiscard]] std::vector<Vec3> cylinder_samples(const Hole& hole);

[[nodiscard]] double cylinder_volume(const Hole& hole);  // [m3]

// What one block face on the hole, given by its geometry, adds to the volume that the hole's faces
// enclose [m3]: divergence theorem with half the vector from the axis line as the field. The sum
// over a closed hole is exact; a box wall at right angles to the axis or through it adds nothing.
[[nodiscard]] double enclosed_by_face(const Hole& hole, const FaceGeometry& face);

template <class Predicate>
double cylinder_volume_where(const Hole& hole, Predicate is_ground) {
  const std::vector<Vec3> samples = cylinder_samples(hole);
  std::size_t hits = 0;
  for (const Vec3& p : samples) hits += is_ground(p) ? 1 : 0;
  return cylinder_volume(hole) * static_cast<double>(hits) / static_cast<double>(samples.size());
}

}  // namespace muckpile
