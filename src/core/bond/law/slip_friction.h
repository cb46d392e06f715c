// SPDX-License-Identifier: GPL-2.0-or-later
// Friction of broken joints: the one place that asks a joint law for it. It may fall with the speed
// of slip: the asperities of fast rock faces heat up within their short contact and lose their
// strength (flash heating).
// Scope: a pure function of a point, one per lane; the steady law of Rice (2006), J. Geophys. Res.
// 111, B05311, without its state: asperities are renewed within a slip of some 10 um.
#pragma once

#include "math/lanes.h"

namespace muckpile {

struct SlipWeakening {
  double speed = 0.0;         ///< V_w, above which friction falls; 0: never [m/s]
  double tan_weakened = 0.0;  ///< f_w, what is left of the friction at high speed [-]
};

/// `Law`: a joint law, or a reference to one.
template <class Number, class Law>
struct SlipFriction {
  Law law;
  Number slip;  ///< since the points broke [m]
  Number grip;  ///< 1; 0 at a mirror, which has no friction
  SlipWeakening weakening{};

  /// The shear that friction can hold under a normal traction, not positive, at that speed of slip,
  /// squared [Pa], [m2/s2].
  [[nodiscard, gnu::always_inline]] Number limit(const Number& normal,
                                                 const Number& speed_squared) const {
    return -sliding(grip * law.friction(-normal, slip), speed_squared) * normal;
  }
  /// f_w + (f - f_w) V_w/v above V_w, f below; f where that is not above f_w anyway.
  [[nodiscard]] Number sliding(const Number& slow, const Number& speed_squared) const;
};

template <class Number, class Law>
Number SlipFriction<Number, Law>::sliding(const Number& slow, const Number& speed_squared) const {
  if (weakening.speed == 0.0) return slow;
  const Number falls = slow - weakening.tan_weakened;
  const double start = weakening.speed;
  const auto fast = speed_squared > start * start && falls > 0.0;
  if (none_of(fast)) return slow;
  const Number speed = sqrt(choose(fast, speed_squared, 1.0));
  return choose(fast, weakening.tan_weakened + falls * start / speed, slow);
}

}  // namespace muckpile
