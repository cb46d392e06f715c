// SPDX-License-Identifier: GPL-2.0-or-later
// The rigid body of a block: exact mass, centre and principal inertia of its polyhedron, and the
// spheres that carry contact.
// Scope: start configuration, space coordinates unless said otherwise.
#pragma once

#include <vector>

#include "geometry/block_model.h"
#include "geometry/spheres/contact_spheres.h"
#include "state/encoding.h"

namespace muckpile {

struct RigidBody {
  double mass = 0.0;    ///< [kg]
  double volume = 0.0;  ///< [m3]
  Vec3 centre;          ///< [m]
  Vec3 inertia;         ///< principal moments [kg m2]
  Mat3 axes;            ///< principal axes, right-handed columns
  std::vector<Sphere> spheres;
};
template <>
struct Stored<RigidBody> {
  static constexpr std::string_view kName = "rigid_body";
  static constexpr int kVersion = 1;
  static auto fields(auto& body) {
    return std::tie(body.mass, body.volume, body.centre, body.inertia, body.axes, body.spheres);
  }
};

[[nodiscard]] RigidBody rigid_body(const Block& block, double density, const SphereRule& spheres);

/// Largest overlap of two spheres of neighbouring blocks over the smaller radius [-].
[[nodiscard]] double largest_overlap(const std::vector<Block>& blocks,
                                     const std::vector<RigidBody>& bodies);

}  // namespace muckpile
