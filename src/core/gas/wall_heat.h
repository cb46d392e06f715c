// SPDX-License-Identifier: GPL-2.0-or-later
// Heat that hot gas loses to the rock walls of a crack: turbulent film, then conduction into rock.
// Scope: one wall, half space, one-dimensional; no radiation, no condensation of steam, and the
// rock keeps its conductivity however hot it gets.
#pragma once

#include <cmath>

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

  /// Film of a flow by Chilton and Colburn's analogy, h = St G cp with St = f/8 Pr^(-2/3)
  /// [W/(m2 K)]: f is Darcy's friction factor, `flux` G in kg/(m2 s), `heat_capacity` cp in
  /// J/(kg K).
  [[nodiscard]] double film(double friction, double flux, double heat_capacity) const {
    return 0.125 * friction * analogy_ * flux * heat_capacity;
  }

  /// Heat flux [W/m2] into a wall that has taken Q = `taken` [J/m2], from gas of a temperature [K]
  /// through a film [W/(m2 K)]. Film and rock in series, at a wall temperature Tw:
  ///     q = h (T - Tw) = (2/pi) e^2 (Tw - T0)^2/Q.
  /// The right side is exact for a wall of constant temperature (q = e dT (pi t)^(-1/2), Q = 2 e dT
  /// (t/pi)^(1/2)); for a constant flux it would be pi/4 instead of 2/pi, 11 % in Tw - T0. Never
  /// from the rock into colder gas.
  [[nodiscard]] double flux(double temperature, double film, double taken) const {
    const double excess = temperature - p_.rock_temperature;
    if (!(excess > 0.0) || !(film > 0.0)) return 0.0;
    // x = (Tw - T0)/excess solves x^2 + 2 b x = 2 b with b = h Q/(2 B excess).
    const double b = 0.5 * film * taken / (conduction_ * excess);
    const double wall = 2.0 * b / (b + std::sqrt(b * (b + 2.0)));
    return b > 0.0 ? film * excess * (1.0 - wall) : film * excess;
  }

 private:
  Parameters p_;
  double analogy_;     // Pr^(-2/3)
  double conduction_;  // (2/pi) e^2
};

}  // namespace muckpile
