// SPDX-License-Identifier: GPL-2.0-or-later
// A facet between two rocks: how its jump splits between them, and how stiff they are in series.
// Scope: pure functions of the two rocks and of the distances of the facet from the two centres; SI
// units, per area. The joint itself is not in it: it acts in series with both (linear_closure.h).
//
// Rock i reaches over d_i from its centre to the facet, rock j over d_j. A jump u_n along the
// normal is d_i e_i + d_j e_j of the strains e of both, and their tractions are the same where
// (lambda + 2G) e is: exact for uniaxial strain, and in every strain without dilatation in the
// plane of the facet, or where both rocks have the same lambda. A jump u_s along the facet splits
// so that G e_s is the same. The traction is the gradient of the energy of both sides,
//     d_i (G_i |e_i|^2) + d_j (G_j |e_j|^2) + the dilatations' part,
// hence one and the same for both blocks whatever the strain.
#pragma once

#include <array>

#include "bond/law/joint_material.h"
#include "math/types.h"

namespace muckpile {

struct TwoRocks {
  double uniaxial = 0.0;  ///< of both in series against uniaxial strain [Pa/m]
  double normal = 0.0;    ///< elastic part of the normal traction per jump, without dilatations
  double shear = 0.0;     ///< tangential traction per jump [Pa/m]
  /// Strain of the side of i and of j, times d_i + d_j, over the jump: along the normal, and across
  /// it. Both are 1 where the rocks are the same [-].
  std::array<double, 2> along{1.0, 1.0}, across{1.0, 1.0};

  /// m of the block on one side (0: i), by which the whole jump dilates it [-].
  [[nodiscard]] Vec3 opening(std::size_t side, const Vec3& m, const Vec3& normal_of_facet) const {
    return across[side] * m +
           (along[side] - across[side]) * normal_of_facet.dot(m) * normal_of_facet;
  }
};

/// `depth_i`, `depth_j`: distances of the facet from the two centres along its normal [m].
[[nodiscard]] TwoRocks two_rocks(const JointMaterial& rock_i, double depth_i,
                                 const JointMaterial& rock_j, double depth_j);

/// What lies between two rocks: of every strength, friction, stiffness of the joint itself, share of
/// damping and fracture energy the lesser; strength that grows less with the rate of strain.
[[nodiscard]] JointParameters weaker_of(const JointParameters& a, const JointParameters& b);

}  // namespace muckpile
