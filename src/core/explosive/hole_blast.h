// SPDX-License-Identifier: GPL-2.0-or-later
// One charged hole through time: what its crushed-zone wall feels, and when it is over.
// Scope: BlastLoad on the clock of a DetonationFront; times [s] on the blast's own clock.
#pragma once

#include "explosive/blast_load.h"
#include "explosive/detonation_front.h"

namespace muckpile {

class HoleBlast {
 public:
  HoleBlast(const BlastLoad& load, const DetonationFront& front) : load_(load), front_(front) {}

  [[nodiscard]] double firing_time() const { return front_.firing_time(); }  ///< [s]
  /// When the detonation passes the height of a wall point [s].
  [[nodiscard]] double arrival_time(const Vec3& point) const { return front_.arrival_time(point); }
  /// Pressure of the gas in the whole hole [Pa] at a swept volume [m3]; 0 before the hole fires.
  [[nodiscard]] double gas_pressure(double swept_volume, double time,
                                    const GasState& state = {}) const;
  /// Of that what presses on the wall of the crushed zone [-].
  [[nodiscard]] double wall_share(double swept_volume, const GasState& state) const {
    return load_.wall_share(swept_volume - state.swept_before);
  }
  /// What the products can press at most while the pulse acts [Pa]; see BlastLoad.
  [[nodiscard]] double pulse_limit(double swept_volume, double time, const GasState& state) const;
  /// Energy of that gas [J], and what it takes along as it leaves [J/kg]; 0 before the hole fires.
  [[nodiscard]] double gas_energy(double swept_volume, double time, const GasState& state) const;
  [[nodiscard]] double gas_enthalpy(double swept_volume, double time, const GasState& state) const;
  /// Takes a share of the products and an energy [J] out of the hole; see BlastLoad.
  void take_gas(GasState& state, double swept_volume, double time, double share,
                double energy) const {
    load_.take_gas(state, swept_volume - state.swept_before, time - front_.firing_time(), share,
                   energy);
  }
  /// Room of the gas [m3].
  [[nodiscard]] double gas_volume(double swept_volume, const GasState& state) const {
    return load_.gas_room(swept_volume - state.swept_before, state);
  }
  /// What the gas and the stemming do in one step [s]. Before the hole fires there is no gas, and
  /// the products start from their own volume wherever other holes have moved the wall by then: it
  /// is the rock of the crushed zone, not yet crushed, that has been strained, and the hole in it
  /// by its small share of that.
  void advance(GasState& state, double swept_volume, double time, double dt) const;
  /// Load [Pa] on a wall point of that arrival time.
  [[nodiscard]] double pressure(double arrival_time, double time, double gas_pressure,
                                double pulse_limit = BlastLoad::kNoLimit) const {
    return load_.pressure(time - arrival_time, gas_pressure, pulse_limit);
  }
  /// True once the detonation has run the whole column and no load above kNegligible times the
  /// greatest is left.
  [[nodiscard]] bool over(double time, double gas_pressure) const;

  /// True once the pulse has all but passed every point of the wall (BlastLoad::pulse_over).
  [[nodiscard]] bool pulse_over(double time) const {
    return load_.pulse_over(time - front_.last_arrival_time());
  }

  /// When softened joints bear what is left of the pulse, wherever on the wall [s].
  [[nodiscard]] double pulse_end() const { return front_.last_arrival_time() + load_.pulse_end(); }

  [[nodiscard]] const BlastLoad& load() const { return load_; }
  [[nodiscard]] const DetonationFront& front() const { return front_; }

  /// Share of the greatest load at which a hole counts as over: some 20 kPa of 200 MPa, less than
  /// the atmosphere that the model leaves out.
  static constexpr double kNegligible = 1e-4;

 private:
  BlastLoad load_;
  DetonationFront front_;
};

}  // namespace muckpile
