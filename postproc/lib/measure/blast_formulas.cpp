// SPDX-License-Identifier: GPL-2.0-or-later
// Rules of practice for vibration and fly rock.
// Scope: see the header.
#include "measure/blast_formulas.h"

#include <cmath>

namespace muckpile {

double bureau_of_mines_ppv(double scaled_distance) {
  constexpr double kInch = 0.0254, kFoot = 0.3048, kPound = 0.45359237;  // [m], [m], [kg]
  return 234.0 * kInch * std::pow(scaled_distance * std::sqrt(kPound) / kFoot, -1.62);
}

double richards_moore_range(double constant, double mass_per_metre, double confinement) {
  constexpr double kGravity = 9.81;  // [m/s2]
  return constant * constant / kGravity * std::pow(std::sqrt(mass_per_metre) / confinement, 2.6);
}

}  // namespace muckpile
