// SPDX-License-Identifier: GPL-2.0-or-later
// Flow of gas along a rough crack: quasi-steady, turbulent, never above the choked flow.
// Scope: one crack of even aperture; ideal gas on an isentrope p = K rho^gamma; no heat loss, no
// inertia of the gas. What depends on the gas alone and on the crack alone is worked out once for
// each (GasHead, passage()): there are many cracks to a body of gas.
#pragma once

#include <algorithm>
#include <cmath>

#include "math/powers.h"

namespace muckpile {

/// Of a gas at rest.
struct GasPoint {
  double pressure = 0.0;  ///< [Pa]
  double density = 0.0;   ///< [kg/m3]
};

/// What drives a gas through a crack.
struct GasHead {
  double pressure = 0.0, inverse_pressure = 0.0;  ///< [Pa], [1/Pa]; 0 if empty
  double root = 0.0, inverse_root = 0.0;  ///< p^(1/gamma): on any one isentrope as the density
  double speed = 0.0;                     ///< (p rho)^(1/2) [kg/(m2 s)]
};

class CrackFlow {
 public:
  struct Parameters {
    double gamma = 1.4;       ///< of the expanded gas, > 1
    double roughness = 1e-4;  ///< k, height of the asperities [m]
  };

  /// InputError on a value out of range.
  explicit CrackFlow(const Parameters& parameters);

  [[nodiscard]] double root_of(double pressure) const {
    return pressure > 0.0 ? power_of(pressure, 1.0 / p_.gamma) : 0.0;
  }
  [[nodiscard]] static GasHead head(const GasPoint& gas, double root) {
    if (!(gas.pressure > 0.0)) return {};
    return {gas.pressure, 1.0 / gas.pressure, root, 1.0 / root,
            std::sqrt(gas.pressure * gas.density)};
  }
  [[nodiscard]] GasHead head(const GasPoint& gas) const { return head(gas, root_of(gas.pressure)); }
  /// Downstream over upstream density, x = (p_down/p_up)^(1/gamma) [-].
  [[nodiscard]] static double thinning(const GasHead& upstream, const GasHead& downstream) {
    return downstream.root * upstream.inverse_root;
  }

  /// Mass flow per area of the crack [kg/(m2 s)], without inertia:
  ///     G^2/(2 s^2) = integral of rho dp = gamma/(gamma + 1) p rho [1 - x^(gamma + 1)],
  /// s the passage; never above the choked flux; 0 uphill.
  [[nodiscard]] double flux(const GasHead& upstream, const GasHead& downstream,
                            double passage) const {
    if (!(downstream.pressure < upstream.pressure)) return 0.0;
    const double left = downstream.pressure * upstream.inverse_pressure;
    const double fall = std::max(0.0, 1.0 - left * thinning(upstream, downstream));
    return upstream.speed * std::min(drive_ * std::sqrt(fall) * passage, choked_);
  }
  /// Share of the flow without friction that `length` L [m] of a crack of that aperture w [m] lets
  /// through: (1 + f L/(2w))^(-1/2). The 1 is the gas coming up to speed, 2w the hydraulic
  /// diameter, f = 0.143 (k/w)^(1/3) (Gauckler, Manning and Strickler; Tsai & Rice 2010;
  /// docs/sources.md).
  [[nodiscard]] double passage(double aperture, double length) const {
    return passage_against(resistance(aperture, length));
  }
  /// The f L/(2w) of that [-].
  [[nodiscard]] double resistance(double aperture, double length) const {
    const double root = inverse_cube_root(aperture);
    return 0.5 * friction_ * length * (root * root) * (root * root);
  }
  [[nodiscard]] static double passage_against(double resistance) {
    return 1.0 / std::sqrt(1.0 + resistance);
  }
  /// Darcy's f at an aperture [m].
  [[nodiscard]] double friction_factor(double aperture) const;
  [[nodiscard]] double gamma() const { return p_.gamma; }

 private:
  Parameters p_;
  double choked_;    // choked flux over (p rho)^(1/2)
  double drive_;     // flux into nothing without friction over that
  double friction_;  // f w^(1/3) [m^(1/3)]
};

}  // namespace muckpile
