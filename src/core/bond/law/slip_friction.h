// SPDX-License-Identifier: GPL-2.0-or-later
// Friction that falls with the speed of slip: the asperities of fast rock faces heat up within
// their short contact and lose their strength (flash heating).
// Scope: a pure function of one facet's points; the steady law of Rice (2006), J. Geophys. Res.
// 111, B05311, without its state: asperities are renewed within a slip of some 10 um.
#pragma once

#include "math/lanes.h"

namespace muckpile {

struct SlipWeakening {
  double speed = 0.0;         ///< V_w, above which friction falls; 0: never [m/s]
  double tan_weakened = 0.0;  ///< f_w, what is left of the friction at high speed [-]
};

/// f_w + (f - f_w) V_w/v above V_w, f below; f where that is not above f_w anyway.
template <class Number>
[[nodiscard]] Number sliding_friction(const Number& tan_slow, const Number& speed_squared,
                                      const SlipWeakening& weakening) {
  if (weakening.speed == 0.0) return tan_slow;
  const Number falls = tan_slow - weakening.tan_weakened;
  const double start = weakening.speed;
  const auto fast = speed_squared > start * start && falls > 0.0;
  if (none_of(fast)) return tan_slow;
  const Number speed = sqrt(choose(fast, speed_squared, 1.0));
  return choose(fast, weakening.tan_weakened + falls * start / speed, tan_slow);
}

}  // namespace muckpile
