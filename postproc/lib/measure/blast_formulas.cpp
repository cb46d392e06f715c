// SPDX-License-Identifier: GPL-2.0-or-later
// Rules of practice for vibration and fly rock.
// Scope: see the header.
#include "measure/blast_formulas.h"

#include <algorithm>
#include <cmath>

namespace muckpile {
namespace {

// SDoB^-2.167 d^(2/3), d in mm.
double mckenzie_scale(double depth_of_burial, double diameter) {
  return std::pow(depth_of_burial, -2.167) * std::pow(1e3 * diameter, 2.0 / 3.0);
}

}  // namespace

double bureau_of_mines_ppv(double scaled_distance) {
  constexpr double kInch = 0.0254, kFoot = 0.3048, kPound = 0.45359237;  // [m], [m], [kg]
  return 234.0 * kInch * std::pow(scaled_distance * std::sqrt(kPound) / kFoot, -1.62);
}

double richards_moore_range(double constant, double mass_per_metre, double confinement) {
  constexpr double kGravity = 9.81;  // [m/s2]
  return constant * constant / kGravity * std::pow(std::sqrt(mass_per_metre) / confinement, 2.6);
}

double gun_barrelling_range(double constant, double mass_per_metre, double stemming, double angle) {
  return richards_moore_range(constant, mass_per_metre, stemming) * std::sin(2.0 * angle);
}

double scaled_depth_of_burial(double stemming, double charge_length, double diameter,
                              double mass_per_metre) {
  constexpr double kNarrow = 0.1;  // [m]
  const double counted = std::min(charge_length, (diameter < kNarrow ? 8.0 : 10.0) * diameter);
  return (stemming + 0.5 * counted) / std::cbrt(mass_per_metre * counted);
}

double mckenzie_range(double depth_of_burial, double diameter) {
  return 9.74 * mckenzie_scale(depth_of_burial, diameter);
}

double mckenzie_fragment(double depth_of_burial, double diameter, double rock_density) {
  return 3e-3 * mckenzie_scale(depth_of_burial, diameter) * 2600.0 / rock_density;
}

}  // namespace muckpile
