// SPDX-License-Identifier: GPL-2.0-or-later
// The rock cut into blocks: what the tessellation makes and the engine, joints and output read.
// Scope: data only; all lengths in metres.
#pragma once

#include <vector>

#include "geometry/shape/polyhedron.h"
#include "state/encoding.h"

namespace muckpile {

// The crushed zone of one charge: a finite cylinder. The rock in it is removed.
struct Hole {
  Vec3 toe = Vec3::Zero();     // lower end of the axis [m]
  Vec3 collar = Vec3::Zero();  // upper end of the axis [m]
  double radius = 0.0;         // [m]
  double share = 1.0;  // that is modelled: 1/2 with the axis in a mirror plane, 1/4 in two [-]
};
template <>
struct Stored<Hole> {
  static constexpr std::string_view kName = "hole";
  static constexpr int kVersion = 2;
  static auto fields(auto& hole) {
    return std::tie(hole.toe, hole.collar, hole.radius, hole.share);
  }
};

inline constexpr int kFreeFace = -1;  // neighbour code: face on the boundary of the region
// Neighbour code: face on the crushed zone of hole number `hole` (>= 0).
[[nodiscard]] inline constexpr int hole_face(int hole) { return -2 - hole; }
[[nodiscard]] inline constexpr bool is_hole_face(int neighbour) { return neighbour <= -2; }
[[nodiscard]] inline constexpr int hole_of_face(int neighbour) { return -2 - neighbour; }

struct Block {
  Polyhedron shape;
  MassProperties mass;
  std::vector<int> neighbour;  // per face: block number >= 0, kFreeFace or hole_face(h)
  double target_size = 0.0;    // V^(1/3) that the size law asks for at the centroid [m]
};

}  // namespace muckpile
