// SPDX-License-Identifier: GPL-2.0-or-later
// Flow of gas along a rough crack: quasi-steady, turbulent, never above the choked flow.
// Scope: one crack of even aperture; ideal gas on an isentrope p = K rho^gamma; no heat loss, no
// inertia of the gas.
#pragma once

namespace muckpile {

/// Of a gas at rest.
struct GasPoint {
  double pressure = 0.0;  ///< [Pa]
  double density = 0.0;   ///< [kg/m3]
};

class CrackFlow {
 public:
  struct Parameters {
    double gamma = 1.4;       ///< of the expanded gas, > 1
    double roughness = 1e-4;  ///< k, height of the asperities [m]
  };

  /// InputError on a value out of range.
  explicit CrackFlow(const Parameters& parameters);

  /// How far the pressure falls along a crack.
  struct Fall {
    double ratio;     ///< downstream over upstream pressure [-]
    double thinning;  ///< x = ratio^(1/gamma), downstream over upstream density [-]
  };
  [[nodiscard]] Fall fall(double upstream_pressure, double downstream_pressure) const;

  /// Mass flow per area of the crack [kg/(m2 s)] from `upstream`, without inertia:
  ///     G^2/(2 s^2) = integral of rho dp = gamma/(gamma + 1) p rho [1 - x^(gamma + 1)],
  /// s the passage, x of the fall; never above the choked flux.
  [[nodiscard]] double flux(const GasPoint& upstream, const Fall& fall, double passage) const;
  /// Share of the flow without friction that `length` L [m] of a crack of that aperture w [m] lets
  /// through: (1 + f L/(2w))^(-1/2). The 1 is the gas coming up to speed, 2w the hydraulic
  /// diameter, f = 0.143 (k/w)^(1/3) (Gauckler, Manning and Strickler; Tsai & Rice 2010, quoted
  /// from memory).
  [[nodiscard]] double passage(double aperture, double length) const;
  /// Darcy's f at an aperture [m].
  [[nodiscard]] double friction_factor(double aperture) const;
  [[nodiscard]] double gamma() const { return p_.gamma; }

 private:
  Parameters p_;
  double choked_;  // choked flux over (p rho)^(1/2)
};

}  // namespace muckpile
