// SPDX-License-Identifier: GPL-2.0-or-later
// Pressure on the wall of the crushed zone: the stress-wave pulse, then the detonation gas.
// Scope: one hole; the gas has one pressure in the whole hole and follows the volume that the wall
// sweeps; it leaks by a time law, or by flow through collar and cracks (gas_vent.h).
#pragma once

#include <algorithm>
#include <limits>
#include <optional>

#include "explosive/gas_vent.h"
#include "explosive/product_expansion.h"
#include "explosive/pulse_shape.h"

namespace muckpile {

/// Share of the gas that has not vented: 1 until vent_time, then exp(-(t - vent_time)/vent_decay).
/// Times [s] since the primer fired. The exponential form is our choice.
[[nodiscard]] double vent_factor(double time, double vent_time, double vent_decay);

/// T, below, of gas in a volume within a crushed zone of that volume with its hole, whose rock has
/// the friction angle phi [rad]; 1 without a zone.
[[nodiscard]] double crushed_rock_share(double gas_volume, double zone_volume, double friction);

/// Load at a wall point, tau = time since the detonation arrived there:
///     p = max( min[P1 f(tau), p_limit], p_gas(V, t) g(tau) )
/// P1 is the peak wave pressure at the wall, f the pulse's shape, and g = f until the peak (of a
/// table its greatest so far) and 1 after. The load is the maximum, not the sum, because the pulse
/// is the first part of the same expansion. Before the peak it is the pulse alone wherever P1 >=
/// p_gas; if P1 < p_gas the gas comes up along the pulse's own rise. Either way it never jumps.
///
/// Gas:
///     p_gas = p(V/V0) s(t),  V = Vg + swept volume
/// V0 is the charge volume, p(V/V0) the isentrope, s the vent factor. Vg is the isentrope's Vk, or
/// the room of a decoupled charge if that is more. For the two-stage law p_gas is pk (Vk/V)^gamma2
/// s(t) as long as the wall has not moved inward. With flow in place of s(t) the gas that is left,
/// a share m of the mass, fills the chamber alone: p_gas = k p(V/(m V0)), k = 1 unless gas of
/// another temperature has come in or gone (GasState::hotter).
///
/// What of it presses on the wall of the crushed zone, r1, is
///     T p_gas,  T = min(1, (r/r1)^(1 - K)) = min(1, [V/(Vz + swept volume)]^((1 - K)/2)),
/// K = (1 - sin phi)/(1 + sin phi): the gas presses on the wall of the hole, at r, and crushed rock
/// that yields by its friction phi keeps sigma_theta = K sigma_r between r and r1, so equilibrium
/// makes sigma_r fall as r^-(1 - K) (Yu 2000; docs/sources.md). Plane strain, the crushed rock
/// neither dilates nor lets gas through; Vz is the volume of the crushed zone with the hole. What
/// the gas does beyond T p_gas dV is spent there. Without Vz or phi T is 1. Limit where the wall
/// gives way: the pulse presses no more than the isentrope gives from the volume Vp in which the
/// products start, V0 or the room of a decoupled charge:
///     p_limit = p((Vp + swept volume)/V0) s(t)
/// To all these volumes of gas comes what the stemming has cleared, with venting by flow.
/// As Vg >= Vp, p_gas is never above p_limit: pulse and gas together do no more work than the
/// products' expansion from Vp.
class BlastLoad {
 public:
  struct Parameters {
    double wave_peak;                             ///< P1 [Pa], 0 for no pulse
    PulseParameters pulse{};                      ///< its shape
    std::optional<ProductExpansion> expansion{};  ///< nothing: pulse only; all below is then unused
    double charge_volume;                         ///< V0 [m3]
    double products_mass = 1.0;                   ///< of the gas of the charge [kg]
    double free_volume_ratio = 1.0;               ///< chamber that the products fill over V0 [-]
    double pulse_volume_ratio = 1.0;              ///< Vp/V0, at most free_volume_ratio [-]
    double zone_volume = 0.0;                     ///< Vz, of the crushed zone and the hole [m3]
    double crushed_friction = 0.0;                ///< phi, of crushed rock [rad]
    double vent_time;                             ///< since the primer fired [s]
    double vent_decay;                            ///< [s]
    std::optional<GasVent::Parameters> flow{};    ///< in place of those two times
  };

  /// InputError on a value out of range.
  explicit BlastLoad(const Parameters& parameters);

  /// Gas pressure [Pa] at a swept volume [m3] and a time [s] since the primer fired; 0 without gas.
  [[nodiscard]] double gas_pressure(double swept_volume, double time,
                                    const GasState& state = {}) const;
  /// Room of the gas [m3]; a wall that has moved inward leaves it some in the crushed rock.
  [[nodiscard]] double gas_room(double swept_volume) const {
    constexpr double kLeast = 0.1;  // of the charge's volume
    return std::max(start_volume_ + swept_volume, kLeast * charge_volume_);
  }
  /// That, and what the stemming has cleared [m3].
  [[nodiscard]] double gas_room(double swept_volume, const GasState& state) const {
    return gas_room(swept_volume) + cleared_room(state);
  }
  /// T, of a gas pressure what presses on the wall of the crushed zone [-].
  [[nodiscard]] double wall_share(double swept_volume) const;
  /// What the gas that is left could still do as it expands to nothing, at a swept volume; 0
  /// without gas [J].
  [[nodiscard]] double gas_energy(double swept_volume, double time,
                                  const GasState& state = {}) const;
  /// What gas takes along that leaves the chamber: its energy and p/rho; 0 without gas [J/kg].
  [[nodiscard]] double gas_enthalpy(double swept_volume, double time,
                                    const GasState& state = {}) const;
  /// Takes a share of the products and an energy [J] out of the chamber, at one volume; both may be
  /// negative. What is left is as much hotter than on its isentrope as its energy says.
  void take_gas(GasState& state, double swept_volume, double time, double share,
                double energy) const;
  /// Where the energy of the products is as the gas stage starts [J]; zeros without gas.
  struct StartEnergies {
    double products = 0.0;  ///< what their expansion to nothing can do
    double filling = 0.0;   ///< of that, lost on the way to Vp: the room of a decoupled charge
    double dense = 0.0;     ///< of that, from Vp to Vg: for the pulse, and to crush the rock
  };
  [[nodiscard]] StartEnergies start_energies() const;
  /// p_limit [Pa]. Infinite without gas: then there is no isentrope, and the pulse is as given.
  [[nodiscard]] double pulse_limit(double swept_volume, double time,
                                   const GasState& state = {}) const;
  /// The gas that flows out and the stemming that moves in one step [s].
  void advance(GasState& state, double swept_volume, double time, double dt) const;
  /// Load [Pa] at a point that the detonation reached tau seconds ago, under that gas pressure.
  [[nodiscard]] double pressure(double tau, double gas_pressure,
                                double pulse_limit = kNoLimit) const;
  /// Bound on pressure() at tau and later if the gas pressure does not rise above the given one;
  /// P1 or the gas pressure before the peak.
  [[nodiscard]] double bound(double tau, double gas_pressure) const;

  /// True once less than kPulseLeft of the pulse's peak is to come, tau and later.
  [[nodiscard]] bool pulse_over(double tau) const;

  /// tau from which on softened joints bear what is left of the pulse [s]; 0 without a pulse.
  [[nodiscard]] double pulse_end() const { return wave_peak_ > 0.0 ? pulse_.end(kPulseGone) : 0.0; }

  [[nodiscard]] double wave_peak() const { return wave_peak_; }          ///< P1 [Pa]
  [[nodiscard]] double start_volume() const { return start_volume_; }    ///< Vg [m3], 0 without gas
  [[nodiscard]] double charge_volume() const { return charge_volume_; }  ///< V0 [m3]
  /// Part of pressure() that the pulse alone would make; the gas adds the rest [-].
  [[nodiscard]] double wave_share(double tau, double gas_pressure,
                                  double pulse_limit = kNoLimit) const;
  /// The greatest load that can occur on a wall that only moves outward [Pa].
  [[nodiscard]] double greatest_pressure() const;

  static constexpr double kNoLimit = std::numeric_limits<double>::infinity();
  static constexpr double kPulseLeft = 0.01;
  /// Of the peak: what a starfield pulse has left after ten rises, 4 (2^-10 - 2^-20).
  static constexpr double kPulseGone = 4.0 * 1023.0 / 1048576.0;

 private:
  [[nodiscard]] double products_pressure(double volume, double time, const GasState& state) const;
  [[nodiscard]] double cleared_room(const GasState& state) const {
    return vent_ ? vent_->cleared_room(state) : 0.0;
  }

  double wave_peak_;
  PulseShape pulse_;
  std::optional<ProductExpansion> expansion_;  // nothing: no gas
  double charge_volume_;
  double start_volume_ = 0.0;
  double zone_volume_;         // [m3]; 0: the gas presses on the wall
  double crushed_friction_;    // [rad]
  double pulse_volume_ = 0.0;  // Vp [m3]
  double vent_time_;
  double vent_decay_;
  double products_mass_;  // [kg]
  std::optional<GasVent> vent_;
};

}  // namespace muckpile
