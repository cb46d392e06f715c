// SPDX-License-Identifier: GPL-2.0-or-later
// The joint law that facets have unless their class has another: closure in proportion to pressure,
// Mohr and Coulomb's strength with a tension cut-off, constant friction.
// Scope: pure functions of one point, one per lane; tension is positive.
#pragma once

#include <optional>

#include "bond/law/joint_law.h"
#include "bond/law/proportional_closure.h"

namespace muckpile {

class JointMaterial;
struct JointLawEntry;
/// For natural joints.
[[nodiscard]] JointLawEntry coulomb_entry();

struct Coulomb : CoulombStrength<double>, ProportionalClosure {
  static constexpr bool kGrouped = true;  ///< JointLaw::grouped()

  [[nodiscard]] std::optional<JointApertures> apertures(double /*closure*/) const { return {}; }
  [[nodiscard]] Coulomb softened(double factor) const {
    Coulomb soft = *this;
    soft.stiffness *= factor;
    return soft;
  }
};

/// Of the numbers of a material and the joints in it.
[[nodiscard]] Coulomb coulomb_of(const JointMaterial& joints);

}  // namespace muckpile
