// SPDX-License-Identifier: GPL-2.0-or-later
// Expansion of the detonation products: steep near the explosion state, then nearly an ideal gas.
// Scope: p(V) of one charge; no heat loss, no reaction after the explosion state.
#pragma once

namespace muckpile {

/// p = P0 (V0/V)^gamma1 while p >= pk, then p = pk (Vk/V)^gamma2, with Vk = V0 (P0/pk)^(1/gamma1).
/// Textbook form with gamma1 = 3, gamma2 = 1.2 to 1.4, pk about 200 MPa (docs/sources.md).
/// If P0 <= pk there is only the second stage, and it starts from P0.
class TwoStageIsentrope {
 public:
  struct Parameters {
    double initial_pressure;         ///< P0, explosion state [Pa]
    double switch_pressure = 200e6;  ///< pk [Pa]
    double dense_exponent = 3.0;     ///< gamma1
    double dilute_exponent = 1.4;    ///< gamma2
  };

  /// InputError unless all are positive and finite.
  explicit TwoStageIsentrope(const Parameters& parameters);

  /// Pressure [Pa] at a volume ratio V/V0; below 1 it stays P0 (the products are not
  /// compressed beyond the explosion state).
  [[nodiscard]] double pressure(double volume_ratio) const;
  /// Vk/V0, where the stages meet (1 if P0 <= pk).
  [[nodiscard]] double switch_ratio() const { return switch_ratio_; }
  /// Pressure where the stages meet [Pa]: pk, or P0 if that is lower.
  [[nodiscard]] double switch_pressure() const { return switch_pressure_; }
  /// Of the second stage [-].
  [[nodiscard]] double gamma() const { return dilute_exponent_; }
  /// Internal energy per volume V0 of charge at a volume ratio V/V0 [J/m3]: all that the expansion
  /// from there to nothing can do. Both exponents must be above 1.
  [[nodiscard]] double stored_energy(double volume_ratio) const;
  /// Work per volume V0 of charge of the expansion from V0 down to a pressure [J/m3].
  [[nodiscard]] double work_down_to(double pressure) const;

 private:
  double initial_pressure_;
  double switch_pressure_;
  double dense_exponent_;
  double dilute_exponent_;
  double switch_ratio_;
};

/// The switch pressure pk [Pa] with which the products hold `energy` per volume V0 of charge [J/m3]
/// at the explosion state. Of `parameters` its own switch pressure does not count. With
/// y = (V0/Vk)^(gamma1 - 1)
///     energy/P0 = (1 - y)/(gamma1 - 1) + y/(gamma2 - 1),   pk = P0 y^(gamma1/(gamma1 - 1)),
/// the sum of the work of the first stage and of what the second holds at pk. InputError with the
/// energies that are possible, P0/(gamma1 - 1) to P0/(gamma2 - 1), if y is not within 0 and 1.
[[nodiscard]] double energy_switch_pressure(const TwoStageIsentrope::Parameters& parameters,
                                            double energy);

}  // namespace muckpile
