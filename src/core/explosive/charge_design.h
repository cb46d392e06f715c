// SPDX-License-Identifier: GPL-2.0-or-later
// What an input script needs of a charge before its rock is cut: the explosive's numbers and the
// radius of the crushed zone.
// Scope: no engine; the command charge_design makes variables of the result.
#pragma once

#include <optional>
#include <string>

#include "args/parse_args.h"
#include "explosive/hole_table.h"

namespace muckpile {

struct ChargeDesign {
  double density = 0.0;                    ///< [kg/m3]
  double detonation_velocity = 0.0;        ///< [m/s]
  double energy = 0.0;                     ///< per mass, 0 if not known [J/kg]
  std::optional<double> crushed_radius{};  ///< with a hole_diameter [m]
  double full_radius = 0.0;                ///< the same of a charge that fills the hole [m]
  std::optional<double> harries_strain{};  ///< on the crushed zone, with the rock's stiffness
  std::optional<HoleTable> pattern{};      ///< with a hole_table
  double pattern_mass = 0.0;               ///< explosive of all its decks [kg]
  double window_mass = 0.0;                ///< the most of it within kVibrationWindow [kg]
  double pattern_crushed_radius = 0.0;     ///< the smallest of its decks [m]
  double pattern_full_radius = 0.0;        ///< the same if all charges filled their chambers [m]
  std::string crushed_table{};             ///< the table with the zones of its decoupled charges
  std::string report{};                    ///< the choice with the alternatives beside it
};

[[nodiscard]] ArgTable charge_design_table();

/// InputError that starts with `where`.
[[nodiscard]] ChargeDesign charge_design(const ArgValues& values, const std::string& where);

}  // namespace muckpile
