// SPDX-License-Identifier: GPL-2.0-or-later
// Decoupled charges; equations in the header.
#include "explosive/decoupling.h"

#include <cmath>
#include <numbers>

#include "args/require.h"

namespace muckpile {

double ChargeShape::charge_volume() const {
  return std::numbers::pi * charge_radius * charge_radius * charge_length;
}

void check_shape(const ChargeShape& shape) {
  require_positive("hole_diameter", "m", 2.0 * shape.hole_radius);
  require_positive("charge_diameter", "m", 2.0 * shape.charge_radius);
  require_positive("charge_length", "m", shape.charge_length);
  if (shape.charge_radius > shape.hole_radius) {
    refuse_value("charge_diameter", "at most hole_diameter", "m", 2.0 * shape.charge_radius);
  }
  constexpr double kRounding = 1e-9;
  if (shape.charge_length > shape.chamber_length * (1.0 + kRounding)) {
    refuse_value("charge_length", "at most the length of its hole's axis", "m",
                 shape.charge_length);
  }
}

double free_volume_ratio(const ChargeShape& shape, const DecouplingRule& rule) {
  const double deck = shape.chamber_length / shape.charge_length;
  if (rule.coupling != Coupling::air) return deck;
  return deck * std::pow(shape.hole_radius / shape.charge_radius, 2.0);
}

ProductExpansion products_in_chamber(const ProductExpansion& expansion, const ChargeShape& shape,
                                     const DecouplingRule& rule) {
  if (rule.air_gap != AirGap::energy) return expansion;
  return expansion.after_filling(free_volume_ratio(shape, rule));
}

double wall_pressure(double initial_pressure, const ProductExpansion& expansion,
                     const ChargeShape& shape, const DecouplingRule& rule) {
  const double ratio = free_volume_ratio(shape, rule);
  const bool decoupled = ratio > 1.0;
  double pressure = initial_pressure;
  if (decoupled && rule.air_gap == AirGap::power) pressure *= std::pow(ratio, -rule.power_exponent);
  if (decoupled && rule.air_gap != AirGap::power) {
    // P0 may come from another formula than the isentrope: only the fall is the isentrope's.
    pressure *=
        products_in_chamber(expansion, shape, rule).pressure(ratio) / expansion.pressure(1.0);
  }
  if (rule.coupling == Coupling::air) return decoupled ? pressure * rule.impact_factor : pressure;
  return pressure * std::pow(shape.charge_radius / shape.hole_radius, rule.coupling_exponent);
}

double pulse_volume_ratio(double wall_share, const ProductExpansion& expansion,
                          const ChargeShape& shape, const DecouplingRule& rule) {
  constexpr double kRounding = 1e-9;
  const double ratio = free_volume_ratio(shape, rule);
  const double products =
      products_in_chamber(expansion, shape, rule).pressure(ratio) / expansion.pressure(1.0);
  return wall_share <= products * (1.0 + kRounding) ? ratio : 1.0;
}

}  // namespace muckpile
