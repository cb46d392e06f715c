// SPDX-License-Identifier: GPL-2.0-or-later
// A charge that does not fill its hole: pressure on the wall, and the room that its products have.
// Scope: a round charge in a round hole, with an air deck above it or not; no wave in the gap.
#pragma once

#include <array>

#include "explosive/product_expansion.h"

namespace muckpile {

/// What stands in the gap around the charge.
enum class Coupling { air, water, stemming };
inline constexpr std::array<const char*, 3> kCouplings{"air", "water", "stemming"};

/// Fall of the products' pressure into an air gap. energy: they fill it without work and keep their
/// energy (ProductExpansion::after_filling). isentrope: as if they had worked against a piston;
/// that work is lost. power: one stage, P0 (r_c/r_b)^(2 g) (l_c/l_b)^g.
enum class AirGap { energy, isentrope, power };

struct ChargeShape {
  double hole_radius = 0.0;     ///< r_b [m]
  double charge_radius = 0.0;   ///< r_c <= r_b [m]
  double chamber_length = 0.0;  ///< l_b, charge and air deck [m]
  double charge_length = 0.0;   ///< l_c <= l_b [m]

  [[nodiscard]] double charge_volume() const;  ///< [m3]
};

struct DecouplingRule {
  Coupling coupling = Coupling::air;
  /// Decay of the peak in water or stemming, (r_c/r_b)^exponent: 0.72 for a line charge in water
  /// (Henrych 1979, after Cole 1948; docs/sources.md).
  double coupling_exponent = 0.72;
  /// How the pressure falls into an air gap.
  AirGap air_gap = AirGap::energy;
  /// Of AirGap::power: 3 gives the usual sixth power, 1.1 to 1.5 is what Bastante (University of
  /// Vigo) has; they differ by 2 to 4 times.
  double power_exponent = 3.0;
  /// Air: shock of the products on the wall over their pressure; 8 to 11 in the literature, for a
  /// wide gap. On the wave only, never on the gas.
  double impact_factor = 1.0;
};

/// InputError unless 0 < r_c <= r_b and 0 < l_c <= l_b.
void check_shape(const ChargeShape& shape);

/// Volume of the chamber that the products fill over that of the charge: (r_b/r_c)^2 l_b/l_c, or
/// l_b/l_c where water or stemming keeps the gap.
[[nodiscard]] double free_volume_ratio(const ChargeShape& shape, const DecouplingRule& rule);

/// The products as they load the wall: as they leave the explosion state, or after filling the room
/// of a decoupled charge if they keep their energy.
[[nodiscard]] ProductExpansion products_in_chamber(const ProductExpansion& expansion,
                                                   const ChargeShape& shape,
                                                   const DecouplingRule& rule);

/// Peak on the borehole wall [Pa]; P0 itself if the charge fills the hole. Along an air deck the
/// products have expanded by its length, whatever stands around the charge.
[[nodiscard]] double wall_pressure(double initial_pressure, const ProductExpansion& expansion,
                                   const ChargeShape& shape, const DecouplingRule& rule);

/// Volume over that of the charge from which the products' work through the wall is counted, given
/// the wall's peak over P0. It is the room that they fill without work; but a peak chosen above
/// their isentrope's there (impact_factor, one power law) has energy from that filling, so then 1.
[[nodiscard]] double pulse_volume_ratio(double wall_share, const ProductExpansion& expansion,
                                        const ChargeShape& shape, const DecouplingRule& rule);

}  // namespace muckpile
