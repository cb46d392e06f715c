// SPDX-License-Identifier: GPL-2.0-or-later
// Heat between gas and the rock walls of a crack: turbulent film, then conduction in the rock
// (rock_layers.h).
// Scope: one wall, half space, one-dimensional; no radiation, no condensation of steam, and the
// rock keeps its conductivity however hot it gets.
#pragma once

#include "gas/rock_layers.h"

namespace muckpile {

class WallHeat {
 public:
  struct Parameters {
    double effusivity = 2500.0;  ///< e = (k rho c)^(1/2) of the rock [W s^(1/2)/(m2 K)]; 0: none
    double rock_temperature = 288.0;  ///< of the rock before the blast [K]
    double prandtl = 0.7;             ///< of the gas [-]
  };

  /// InputError on a value out of range.
  explicit WallHeat(const Parameters& parameters);

  [[nodiscard]] bool acts() const { return p_.effusivity > 0.0; }
  [[nodiscard]] double rock_temperature() const { return p_.rock_temperature; }
  [[nodiscard]] RockLayers rock() const { return RockLayers::half_space(p_.effusivity); }

  /// Film of a flow by Chilton and Colburn's analogy, h = St G cp with St = f/8 Pr^(-2/3)
  /// [W/(m2 K)]: f is Darcy's friction factor, `flux` G in kg/(m2 s), `heat_capacity` cp in
  /// J/(kg K).
  [[nodiscard]] double film(double friction, double flux, double heat_capacity) const {
    return 0.125 * friction * analogy_ * flux * heat_capacity;
  }

 private:
  Parameters p_;
  double analogy_;  // Pr^(-2/3)
};

}  // namespace muckpile
