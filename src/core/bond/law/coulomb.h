// SPDX-License-Identifier: GPL-2.0-or-later
// The strength of a joint by Mohr and Coulomb with a tension cut-off.
// Scope: a pure function of one point, one per lane; tension is positive.
#pragma once

#include <algorithm>

#include "bond/law/linear_closure.h"

namespace muckpile {

struct JointLawEntry;
/// Linear closure with Coulomb's strength, for natural joints.
[[nodiscard]] JointLawEntry coulomb_entry();

template <class Number>
struct CoulombStrength {
  Number tension, cohesion;  ///< [Pa]
  Number tan_friction;       ///< [-]

  /// `normal` traction [Pa]; the shear is asked for squared [Pa2], which spares the root.
  [[nodiscard, gnu::always_inline]] auto fails(const Number& normal,
                                               const Number& shear_squared) const {
    using std::max;
    const Number shear = max(cohesion - normal * tan_friction, Number(0.0));
    return normal > tension || shear_squared > shear * shear;
  }
  /// Whether it does under a traction on a facet of that normal.
  template <class Vector>
  [[nodiscard, gnu::always_inline]] auto fails(const Vector& normal, const Vector& traction) const {
    const Number along = dot(normal, traction);
    return fails(along, Number(dot(traction, traction) - along * along));
  }
  /// Tension and cohesion by a factor each; friction stays.
  [[nodiscard]] CoulombStrength scaled(const Number& in_tension, const Number& in_shear) const {
    return {in_tension * tension, in_shear * cohesion, tan_friction};
  }
};

}  // namespace muckpile
