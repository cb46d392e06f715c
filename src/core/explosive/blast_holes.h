// SPDX-License-Identifier: GPL-2.0-or-later
// The charged holes of a blast through time: gas, pressures and books of each.
// Scope: the caller brings swept volumes and works, summed over ranks, and the time on the blast's
// own clock [s]; no engine. Holes count from 0.
#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "explosive/energy_audit.h"
#include "explosive/hole_blast.h"
#include "explosive/hole_loads.h"

namespace muckpile {

class BlastHoles {
 public:
  /// What a blast goes on from, per hole.
  struct State {
    std::vector<double> swept;  ///< by the wall of the crushed zone [m3]
    std::vector<GasState> gas;
    std::vector<char> over;  ///< never turns back
    std::vector<HoleBooks> books;
  };

  /// Loads and charges, one each per hole; what the holes have done so far stays.
  void set(std::vector<HoleBlast> blasts, std::vector<HoleCharge> charges);
  /// Before set(), to go on from a restart file.
  void resume(State state) { state_ = std::move(state); }

  [[nodiscard]] std::size_t count() const { return blasts_.size(); }
  [[nodiscard]] const HoleBlast& blast(std::size_t hole) const { return blasts_[hole]; }
  [[nodiscard]] const HoleCharge& charge(std::size_t hole) const { return charges_[hole]; }
  [[nodiscard]] const State& state() const { return state_; }

  /// The gas presses on the walls by its excess over `ambient` from now on [Pa].
  void press_against(double ambient) { ambient_ = ambient; }
  [[nodiscard]] double ambient() const { return ambient_; }

  /// True once the first hole has fired.
  [[nodiscard]] bool any_fired(double time) const;
  [[nodiscard]] bool over(std::size_t hole) const { return state_.over[hole] != 0; }
  [[nodiscard]] bool all_over() const;
  /// Holes that have fired and are not over.
  [[nodiscard]] int active(double time) const;

  /// A hole has fired whose pulse has not passed its wall yet.
  [[nodiscard]] bool any_pulse(double time) const;

  /// Before any hole has fired: what the walls have `swept` since the start is not the gas's [m3].
  void start_from(std::span<const double> swept);
  /// Books what the walls have done in the last step: `swept` volume since the start [m3] and
  /// `work` of the step [J] of each hole.
  void book_walls(std::span<const double> swept, std::span<const double> work, double time);
  /// What gas and stemming do in a step [s].
  void advance(double time, double dt);
  /// Finds the pressures of this moment, and ends the holes that do not press any more.
  void press(double time);
  /// Of the gas in a hole beyond the atmosphere, as press() found it [Pa].
  [[nodiscard]] double gas_pressure(std::size_t hole) const { return pressures_[hole].gas; }
  /// On a point of the wall, by the arrival of the detonation there [s]: all that presses [Pa], and
  /// the share of it that is the wave's; as press() found them.
  struct OnWall {
    double pressure = 0.0, wave_share = 0.0;
  };
  [[nodiscard]] OnWall on_wall(std::size_t hole, double arrival, double time) const;

  /// The gas of a hole that is not over [kg], [Pa], [kg/m3]; what has come through the crushed rock
  /// presses no more than that does, as it has been throttled.
  struct Gas {
    double mass = 0.0, pressure = 0.0, density = 0.0;
    double enthalpy = 0.0;  ///< that what leaves takes along [J/kg]
    double energy = 0.0;    ///< that it holds [J/kg]
  };
  [[nodiscard]] Gas gas(std::size_t hole, double time) const;
  /// Moves a mass [kg] and an energy [J] from a hole into joints, or back if negative.
  void take_gas(std::size_t hole, double mass, double energy, double time);
  /// Ends all holes; what gas is left in them goes into the open.
  void release_gas(double time);

  /// Without what the gas has done in joints; zeros before the hole fires.
  [[nodiscard]] EnergyAudit audit(std::size_t hole, double time) const;
  /// That, with what has gone into joints, and the stemming.
  [[nodiscard]] HoleAudit hole_audit(std::size_t hole, double time) const;
  [[nodiscard]] double swept_volume() const;      ///< of all holes [m3]
  [[nodiscard]] double explosive_mass() const;    ///< of all holes [kg]
  [[nodiscard]] double explosive_energy() const;  ///< of all holes [J]

 private:
  struct Pressures {
    double gas = 0.0;      // beyond the atmosphere [Pa]
    double on_wall = 0.0;  // what of that presses on the wall [Pa]
    double limit = 0.0;    // of the pulse [Pa]
  };
  void end(std::size_t hole, double time);

  std::vector<HoleBlast> blasts_;
  std::vector<HoleCharge> charges_;
  State state_;
  std::vector<Pressures> pressures_;
  double ambient_ = 0.0;  // [Pa]
};

}  // namespace muckpile
