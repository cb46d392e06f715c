// SPDX-License-Identifier: GPL-2.0-or-later
// The words of fix muckpile/blast: their table, their meaning, and the hole loads they ask for.
// Scope: no engine; every fault in the words throws InputError that starts with `where`.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "args/parse_args.h"
#include "explosive/borehole_pressure.h"
#include "explosive/hole_blast.h"
#include "geometry/block_model.h"

namespace muckpile {

[[nodiscard]] ArgTable blast_table();

struct BlastOptions {
  std::string where;  ///< starts every message
  Explosive explosive{};
  double hole_radius = 0.0;                ///< charge and hole, fully coupled [m]
  std::optional<double> rock_impedance{};  ///< [Pa s/m]
  double borehole_pressure = 0.0;          ///< P0, by the chosen model or typed [Pa]
  double attenuation_exponent = 0.0;
  std::optional<double> peak_pressure{};  ///< P1 as typed [Pa]
  bool pulse = true;
  double rise_time = 0.0;  ///< [s]
  bool gas = true;
  TwoStageIsentrope::Parameters isentrope{};
  double vent_time = 0.0;           ///< [s]
  double vent_decay = 1.0;          ///< [s]
  double primer = 0.0;              ///< 0 bottom, 1 top
  double interval = 0.0;            ///< between the firing of consecutive holes [s]
  std::map<long, double> delays{};  ///< hole number from 1: its own delay [s]
};

/// Throws InputError where words contradict each other or one that is needed is missing.
[[nodiscard]] BlastOptions blast_options(const ArgValues& values, const std::string& where);

/// The loads of all holes. InputError: no hole, a delay for a hole that is not there, a crushed
/// zone narrower than the hole.
[[nodiscard]] std::vector<HoleBlast> hole_blasts(const BlastOptions& options,
                                                 const std::vector<Hole>& crushed_zones);

/// What was understood, for the log: the pressures chosen and the alternatives beside them, for the
/// first hole, and the firing time of each.
[[nodiscard]] std::string describe(const BlastOptions& options,
                                   const std::vector<Hole>& crushed_zones,
                                   const std::vector<HoleBlast>& blasts);

}  // namespace muckpile
