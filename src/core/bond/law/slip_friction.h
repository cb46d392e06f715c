// SPDX-License-Identifier: GPL-2.0-or-later
// Friction of broken joints. It may fall with the speed of slip: the asperities of fast rock faces
// heat up within their short contact and lose their strength (flash heating).
// Scope: a pure function of a point, one per lane; the steady law of Rice (2006), J. Geophys. Res.
// 111, B05311, without its state: asperities are renewed within a slip of some 10 um.
#pragma once

#include "math/lanes.h"

namespace muckpile {

struct SlipWeakening {
  double speed = 0.0;         ///< V_w, above which friction falls; 0: never [m/s]
  double tan_weakened = 0.0;  ///< f_w, what is left of the friction at high speed [-]
};

template <class Number>
struct SlipFriction {
  Number tan_residual;  ///< of slow slip [-]
  SlipWeakening weakening{};

  /// The shear that friction can hold under a normal traction, not positive, at rest [Pa].
  [[nodiscard, gnu::always_inline]] Number limit(const Number& normal) const {
    return -tan_residual * normal;
  }
  /// And at that speed of slip, squared [m2/s2].
  [[nodiscard, gnu::always_inline]] Number limit(const Number& normal,
                                                 const Number& speed_squared) const {
    return -sliding(tan_residual, speed_squared) * normal;
  }
  /// f_w + (f - f_w) V_w/v above V_w, f below; f where that is not above f_w anyway.
  [[nodiscard]] Number sliding(const Number& tan_slow, const Number& speed_squared) const;
};

template <class Number>
Number SlipFriction<Number>::sliding(const Number& tan_slow, const Number& speed_squared) const {
  if (weakening.speed == 0.0) return tan_slow;
  const Number falls = tan_slow - weakening.tan_weakened;
  const double start = weakening.speed;
  const auto fast = speed_squared > start * start && falls > 0.0;
  if (none_of(fast)) return tan_slow;
  const Number speed = sqrt(choose(fast, speed_squared, 1.0));
  return choose(fast, weakening.tan_weakened + falls * start / speed, tan_slow);
}

}  // namespace muckpile
