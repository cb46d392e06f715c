// SPDX-License-Identifier: GPL-2.0-or-later
// What closes a joint in series with the rock on both sides, and the closure that is in proportion
// to pressure: alone and in series.
// Scope: pure functions of one point, one per lane; per area, pressure is positive in compression.
#pragma once

#include <cmath>
#include <limits>

namespace muckpile {

/// A joint closed in series with the rock on both sides.
template <class Number>
struct JointClosure {
  Number closure;   ///< of the joint; negative where it is pulled open [m]
  Number pressure;  ///< positive in compression [Pa]
  Number rate;      ///< of the closure per jump of joint and rock together, between 0 and 1 [-]
};

struct ProportionalClosure {
  double stiffness = std::numeric_limits<double>::infinity();  ///< infinite: rigid [Pa/m]

  [[nodiscard]] bool rigid() const { return std::isinf(stiffness); }
  /// Of the jump of joint and rock together what strains the rock, of that stiffness [Pa/m] -> [-].
  [[nodiscard]] double rock_share(double rock) const {
    return rigid() ? 1.0 : stiffness / (stiffness + rock);
  }
  /// Stiffness of both together [Pa/m].
  [[nodiscard]] double in_series(double rock) const {
    return rigid() ? rock : rock * stiffness / (rock + stiffness);
  }

  // As JointLaw has them; what was before does not count.
  template <class Number>
  [[nodiscard]] JointClosure<Number> close(const Number& jump, double rock,
                                           const Number& /*largest*/) const {
    const double share = rock_share(rock);
    return {(1.0 - share) * jump, rock * share * jump, 1.0 - share};
  }
  template <class Number>
  [[nodiscard]] Number jump_at(const Number& pressure, double rock,
                               const Number& /*largest*/) const {
    return pressure / stiffness + pressure / rock;
  }
  template <class Number>
  [[nodiscard]] Number stored(const Number& closure, const Number& /*largest*/) const {
    if (rigid()) return 0.0;
    return 0.5 * stiffness * closure * closure;
  }
  template <class Number>
  [[nodiscard]] Number taken(const Number& /*largest*/) const {
    return 0.0;
  }
};

}  // namespace muckpile
