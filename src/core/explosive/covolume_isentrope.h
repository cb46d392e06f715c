// SPDX-License-Identifier: GPL-2.0-or-later
// Expansion of the detonation products as a gas whose molecules take up room.
// Scope: p(V) of one charge; constant exponent and covolume; no heat loss, no reaction on the way.
#pragma once

namespace muckpile {

/// p (V - b)^gamma = P0 (1 - b)^gamma, V over the charge's volume: the isentrope of Noble and
/// Abel's gas p (v - covolume) = R T. Its energy is p (V - b)/(gamma - 1), so the one that holds E
/// per volume of charge at the explosion state has
///     b = 1 - (gamma - 1) E/P0
/// and the work down to a pressure p is E (1 - (p/P0)^((gamma - 1)/gamma)). b over the charge's
/// density is the covolume: 0.3 to 0.5 l/kg for what Muckpile ships, with gamma = 1.4.
class CovolumeIsentrope {
 public:
  struct Parameters {
    double initial_pressure;         ///< P0, explosion state [Pa]
    double energy;                   ///< E per volume of charge [J/m3]
    double gamma = 1.4;              ///< of the products
    double switch_pressure = 200e6;  ///< where the gas stage starts [Pa]; of the load, not the law
  };

  /// InputError unless all are positive, gamma is above 1 and E is at most P0/(gamma - 1).
  explicit CovolumeIsentrope(const Parameters& parameters);

  /// Pressure [Pa] at a volume ratio V/V0; below 1 it stays P0.
  [[nodiscard]] double pressure(double volume_ratio) const;
  /// Per volume V0 of charge at a volume ratio [J/m3]: what the expansion from there can do.
  [[nodiscard]] double stored_energy(double volume_ratio) const;
  [[nodiscard]] double covolume() const { return covolume_; }          ///< b [-]
  [[nodiscard]] double switch_ratio() const { return switch_ratio_; }  ///< [-]
  [[nodiscard]] double gamma() const { return gamma_; }                ///< [-]

 private:
  double initial_pressure_;
  double gamma_;
  double covolume_;
  double switch_ratio_;
};

}  // namespace muckpile
