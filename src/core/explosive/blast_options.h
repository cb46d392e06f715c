// SPDX-License-Identifier: GPL-2.0-or-later
// The words of fix muckpile/blast: their table and their meaning.
// Scope: no engine; every fault in the words throws InputError that starts with `where`.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "args/parse_args.h"
#include "explosive/charge_options.h"
#include "explosive/gas_vent.h"
#include "explosive/hole_table.h"
#include "explosive/pulse_shape.h"

namespace muckpile {

[[nodiscard]] ArgTable blast_table();

enum class Attenuation { exponent, shock, liu_katsabanis };

struct BlastOptions {
  std::string where;  ///< starts every message
  ChargeOptions charge{};
  Attenuation attenuation = Attenuation::exponent;
  std::optional<double> exponent{};       ///< of Attenuation::exponent
  std::optional<double> poisson_ratio{};  ///< of the rock
  std::optional<double> p_wave_speed{};   ///< of the rock [m/s]
  std::optional<double> peak_pressure{};  ///< P1 as typed [Pa]
  bool pulse = true;
  PulseParameters pulse_shape{};
  bool gas = true;
  double crushed_friction = 0.0;       ///< of rock in the crushed zone, against the gas [rad]
  std::optional<double> vent_time{};   ///< as typed [s]
  std::optional<double> vent_decay{};  ///< as typed [s]
  bool vent_by_flow = false;
  GasVent::Parameters flow{};          ///< without radii, mass and gamma
  double primer = 0.0;                 ///< 0 bottom, 1 top
  double interval = 0.0;               ///< between the firing of consecutive holes [s]
  std::map<long, double> delays{};     ///< hole number from 1: its own delay [s]
  std::optional<HoleTable> pattern{};  ///< in place of diameter, interval and delays

  /// P0 counts unless P1 is typed (or there is no pulse) and there is no gas.
  [[nodiscard]] bool needs_borehole_pressure() const { return gas || (pulse && !peak_pressure); }
};

/// Throws InputError where words contradict each other or one that is needed is missing.
[[nodiscard]] BlastOptions blast_options(const ArgValues& values, const std::string& where);

}  // namespace muckpile
