// SPDX-License-Identifier: GPL-2.0-or-later
// Whether points of a facet fail: the one place that asks a joint law for its strength.
// Scope: a pure function of a point, one per lane; tension is positive.
#pragma once

#include "math/lanes.h"

namespace muckpile {

/// Strength over that at rest [-]; 0 where a point has slipped and opens.
template <class Number>
struct StrengthFactors {
  Number tension = 1.0, cohesion = 1.0;
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
