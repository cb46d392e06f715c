// SPDX-License-Identifier: GPL-2.0-or-later
// The joint law that facets have unless their class has another: linear closure, Mohr and Coulomb's
// strength with a tension cut-off, constant friction.
// Scope: pure functions of one point, one per lane; tension is positive.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "bond/law/joint_law.h"

namespace muckpile {

class JointMaterial;
struct JointLawEntry;
/// For natural joints.
[[nodiscard]] JointLawEntry coulomb_entry();

struct Coulomb : CoulombStrength<double> {
  /// Facets are worked on by their stiffness (LinearPoints), which close() gives in series.
  static constexpr bool kLinear = true;

  double normal_stiffness = std::numeric_limits<double>::infinity();  ///< infinite: rigid [Pa/m]

  // As JointLaw has them.
  template <class Number>
  [[nodiscard]] JointClosure<Number> close(const Number& jump, double rock,
                                           const Number& /*largest*/) const {
    const double rate = std::isinf(normal_stiffness) ? 0.0 : rock / (rock + normal_stiffness);
    return {rate * jump, rock * (1.0 - rate) * jump, rate};
  }
  template <class Number>
  [[nodiscard]] Number jump_at(const Number& pressure, double rock,
                               const Number& /*largest*/) const {
    return pressure / normal_stiffness + pressure / rock;
  }
  template <class Number>
  [[nodiscard]] Number stored(const Number& closure, const Number& /*largest*/) const {
    if (std::isinf(normal_stiffness)) return 0.0;
    return 0.5 * normal_stiffness * closure * closure;
  }
  template <class Number>
  [[nodiscard]] Number taken(const Number& /*largest*/) const {
    return 0.0;
  }
  [[nodiscard]] std::optional<JointApertures> apertures(double /*closure*/) const { return {}; }
  [[nodiscard]] Coulomb softened(double factor) const {
    Coulomb soft = *this;
    soft.normal_stiffness *= factor;
    return soft;
  }
};

/// Of the numbers of a material and the joints in it.
[[nodiscard]] Coulomb coulomb_of(const JointMaterial& joints);

}  // namespace muckpile
