// SPDX-License-Identifier: GPL-2.0-or-later
// Expansion of detonation products by the Jones-Wilkins-Lee equation of state.
// Scope: the isentrope through the Chapman-Jouguet point; no afterburning, no heat loss.
#pragma once

namespace muckpile {

struct JwlParameters {
  double a = 0.0, b = 0.0;           ///< [Pa]
  double r1 = 0.0, r2 = 0.0;         ///< [-]
  double omega = 0.0;                ///< [-]
  double cj_pressure = 0.0;          ///< Chapman-Jouguet point [Pa]
  double density = 0.0;              ///< of the charge that was fitted [kg/m3]
  double detonation_velocity = 0.0;  ///< of that charge [m/s]
  double energy = 0.0;               ///< E0 per volume of charge, 0 if not known [J/m3]
};

/// p(V) = A exp(-R1 V) + B exp(-R2 V) + C V^-(1 + omega), V volume over that of the charge: the
/// isentropes of p(V, e) of Lee, Hornig and Kury (1968) as R. Menikoff (2017), JWL Equation of
/// State, Los Alamos LA-UR-15-29536, eq. 1 has it. C makes the curve pass the Chapman-Jouguet point
/// V = 1 - P_CJ/(rho D^2).
class JwlIsentrope {
 public:
  /// Cylinder tests follow the products to about seven times their volume; from there on the last
  /// term alone goes on, a gas of constant exponent 1 + omega.
  static constexpr double kFittedTo = 7.0;

  /// InputError unless A, R1, omega, P_CJ, density and velocity are positive, B and R2 not
  /// negative, V_CJ lies between 0 and 1 and C comes out positive.
  explicit JwlIsentrope(const JwlParameters& parameters);

  /// Pressure [Pa] at a volume ratio V/V0; below 1 it stays that of V = V0.
  [[nodiscard]] double pressure(double volume_ratio) const;
  /// V/V0 at which the pressure has fallen to the given one; 1 if it is never above that.
  [[nodiscard]] double volume_ratio_at(double pressure) const;
  [[nodiscard]] double cj_volume() const { return cj_volume_; }  ///< V_CJ/V0 [-]
  [[nodiscard]] double gas_coefficient() const { return gas_; }  ///< C [Pa]
  /// Of the gas that the last term is [-].
  [[nodiscard]] double gamma() const { return 1.0 + p_.omega; }
  /// Work per volume V0 of charge of the expansion from a volume ratio V/V0 to nothing [J/m3].
  [[nodiscard]] double stored_energy(double volume_ratio) const;
  /// E0 that the curve implies: its energy at V_CJ less P_CJ (1 - V_CJ)/2 [J/m3].
  [[nodiscard]] double implied_energy() const;

 private:
  [[nodiscard]] double curve(double volume) const;
  [[nodiscard]] double energy_from(double volume) const;

  JwlParameters p_;
  double cj_volume_, gas_;
};

/// The JWL isentrope with the gas stage from where it passes a switch pressure p_k.
class JwlGas {
 public:
  /// InputError as JwlIsentrope, or if p_k is passed beyond the volumes that JWL is fitted to.
  JwlGas(const JwlParameters& parameters, double switch_pressure);

  [[nodiscard]] double pressure(double volume_ratio) const {  ///< [Pa]
    return isentrope_.pressure(volume_ratio);
  }
  [[nodiscard]] double stored_energy(double volume_ratio) const {  ///< [J/m3]
    return isentrope_.stored_energy(volume_ratio);
  }
  [[nodiscard]] double switch_ratio() const { return switch_ratio_; }  ///< [-]
  [[nodiscard]] double gamma() const { return isentrope_.gamma(); }    ///< [-]

 private:
  JwlIsentrope isentrope_;
  double switch_ratio_;
};

}  // namespace muckpile
