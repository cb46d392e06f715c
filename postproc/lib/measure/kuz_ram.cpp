// SPDX-License-Identifier: GPL-2.0-or-later
// Kuz-Ram.
// Scope: see the header.
#include "measure/kuz_ram.h"

#include <cmath>
#include <utility>

#include "args/input_error.h"
#include "figures/figures.h"

namespace muckpile {

KuzRamCurve kuz_ram(const KuzRamBlast& b) {
  const std::pair<const char*, double> positive[] = {{"burden", b.burden},
                                                     {"spacing", b.spacing},
                                                     {"bench height", b.bench_height},
                                                     {"hole diameter", b.hole_diameter},
                                                     {"length of charge", b.charge_above_floor},
                                                     {"mass of charge", b.charge_mass},
                                                     {"weight strength", b.weight_strength},
                                                     {"rock factor", b.rock_factor}};
  for (const auto& [name, value] : positive) {
    if (!(value > 0.0))
      refuse("Kuz-Ram", std::string(name) + " must be > 0, got " + check::text_of(value));
  }
  const double powder_factor = b.charge_mass / (b.burden * b.spacing * b.bench_height);  // [kg/m3]
  const double centimetres = b.rock_factor * std::pow(powder_factor, -0.8) *
                             std::pow(b.charge_mass, 1.0 / 6.0) *
                             std::pow(115.0 / b.weight_strength, 19.0 / 30.0);
  const double diameter_mm = 1000.0 * b.hole_diameter;
  const double n = (2.2 - 14.0 * b.burden / diameter_mm) *
                   std::sqrt(0.5 * (1.0 + b.spacing / b.burden)) *
                   (1.0 - b.drilling_deviation / b.burden) * b.charge_above_floor / b.bench_height;
  if (!(n > 0.0))
    refuse("Kuz-Ram",
           "the exponent must be > 0, got " + check::text_of(n) +
               ": the burden is too wide for the hole, or the holes deviate by more than it");
  return {0.01 * centimetres, n};
}

double lilly_rock_factor(double mass_rating, double density, double youngs_modulus, double ucs) {
  constexpr double kStiff = 50e9;  // [Pa]
  const double density_influence = 25.0 * 1e-3 * density - 50.0;
  const double hardness = youngs_modulus < kStiff ? 1e-9 * youngs_modulus / 3.0 : 1e-6 * ucs / 5.0;
  return 0.06 * (mass_rating + density_influence + hardness);
}

}  // namespace muckpile
