// SPDX-License-Identifier: GPL-2.0-or-later
// Whether points of a facet fail: the one place that asks a joint law for its strength; and the
// strength by which facets are worked on in groups.
// Scope: pure functions of a point, one per lane; tension is positive.
#pragma once

#include <algorithm>
#include <cmath>

#include "math/lanes.h"

namespace muckpile {

/// Strength over that at rest [-]; 0 where a point has slipped and opens.
template <class Number>
struct StrengthFactors {
  Number tension = 1.0, cohesion = 1.0;
};

/// Mohr and Coulomb's, with a tension cut-off and constant friction. Of a joint, or of those of a
/// group of facets: `Own` is double or one number per lane.
template <class Own>
struct CoulombStrength {
  Own tension{}, cohesion{};  ///< [Pa]
  Own tan_friction{};         ///< before breaking [-]
  Own tan_residual{};         ///< of broken points at slow slip [-]

  /// See JointLaw.
  template <class Number>
  [[nodiscard, gnu::always_inline]] auto fails(const Number& normal, const Number& shear_squared,
                                               const StrengthFactors<Number>& factors = {}) const {
    using std::max;
    const Number bears = factors.cohesion * cohesion;
    const Number shear = max(bears - normal * tan_friction, Number(0.0));
    return normal > factors.tension * tension || shear_squared > shear * shear;
  }
  template <class Number>
  [[nodiscard, gnu::always_inline]] Number friction(const Number& /*pressure*/,
                                                    const Number& /*slip*/) const {
    return tan_residual;
  }
};

/// A point under a traction, bonded or as if it were.
template <class Number>
struct PointLoad {
  Number normal;         ///< traction, positive in tension [Pa]
  Number shear_squared;  ///< [Pa2], which spares the root

  [[gnu::always_inline]] PointLoad(const VectorOf<Number>& facet_normal,
                                   const VectorOf<Number>& traction)
      : normal(dot(facet_normal, traction)),
        shear_squared(dot(traction, traction) - normal * normal) {}

  template <class Law>
  [[nodiscard, gnu::always_inline]] auto breaks(const Law& law,
                                                const StrengthFactors<Number>& factors = {}) const {
    return law.fails(normal, shear_squared, factors);
  }
};

}  // namespace muckpile
