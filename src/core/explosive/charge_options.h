// SPDX-License-Identifier: GPL-2.0-or-later
// The words that describe a charge: explosive, borehole pressure, expansion, decoupling.
// Scope: shared by fix muckpile/blast and charge_design; every fault throws InputError that starts
// with `where`.
#pragma once

#include <optional>
#include <string>

#include "args/parse_args.h"
#include "explosive/borehole_pressure.h"
#include "explosive/decoupling.h"
#include "explosive/explosive_table.h"

namespace muckpile {

/// A number that may be left to the style: a word in the table, `auto` unless typed.
void add_optional(ArgTable& table, const std::string& name, const std::string& text);
[[nodiscard]] std::optional<double> optional_real(const ArgValues& values, const std::string& where,
                                                  const std::string& name, const std::string& unit,
                                                  Range range);

/// In the order of kModels (charge_options.cpp).
enum class BoreholeModel {
  explosion_state,
  explosion_state_fit,
  explosion_state_gamma,
  chapman_jouguet,
  impedance_matched,
  jwl
};

/// Laws of ProductExpansion.
/// In the order of kExpansions (charge_options.cpp).
enum class Expansion { two_stage, jwl, covolume };

struct ChargeOptions {
  ExplosiveTable table = ExplosiveTable::shipped();
  NamedExplosive explosive{};  ///< with what the user typed in its place; released()
  bool energy_known = false;   ///< explosive.energy counts
  BoreholeModel model = BoreholeModel::explosion_state;
  std::optional<double> typed_pressure{};  ///< P0 [Pa]
  std::optional<double> rock_impedance{};  ///< [Pa s/m]
  Expansion expansion = Expansion::covolume;
  /// Without its initial pressure: p_k of every law, exponents of two_stage and covolume.
  TwoStageIsentrope::Parameters isentrope{};
  bool switch_by_energy = true;  ///< its switch pressure follows from the explosive's energy
  bool switch_typed = false;     ///< the script says how the switch pressure is found
  /// Of the products' energy, spent as the gas stage of a charge that fills its chamber starts, as
  /// typed [-]; nothing: once it presses what the wave does on the wall of the crushed zone.
  std::optional<double> dense_share{};
  double energy_share = 1.0;  ///< of the explosive's energy, what is released in time [-]
  double hole_radius = 0.0;   ///< [m]
  std::optional<double> charge_radius{};  ///< nothing: fills the hole [m]
  std::optional<double> charge_length{};  ///< nothing: fills the axis [m]
  DecouplingRule decoupling{};
  bool coupling_exponent_typed = false;
};

void add_explosive_keywords(ArgTable& table);
void add_borehole_keywords(ArgTable& table);
void add_decoupling_keywords(ArgTable& table);
void add_expansion_keywords(ArgTable& table);
/// The words attenuation and attenuation_exponent; `laws`, described by `text`, may be chosen in
/// place of the exponent.
void add_attenuation_keywords(ArgTable& table, std::vector<std::string> laws,
                              const std::string& text);

/// Fill in `options` from the words that the functions above have added to the table. InputError
/// where words contradict each other or one that is needed is missing. read_explosive() reads those
/// of the explosive and of the borehole pressure.
void read_explosive(ChargeOptions& options, const ArgValues& values, const std::string& where);
void read_decoupling(ChargeOptions& options, const ArgValues& values, const std::string& where);
void read_expansion(ChargeOptions& options, const ArgValues& values, const std::string& where);
/// The exponent as typed or, without one, kStressWaveExponent; nothing where the word `attenuation`
/// names a law that gives it.
[[nodiscard]] std::optional<double> read_attenuation_exponent(const ArgValues& values,
                                                              const std::string& where,
                                                              Range range);

/// The explosive as it detonates when only energy_share of its energy is released in time: so much
/// of it reacts, with its energy and its gas, and the detonation has the square root of that of its
/// velocity unless that was typed (the energy of a detonation goes with its velocity squared).
[[nodiscard]] NamedExplosive released(const ChargeOptions& options, NamedExplosive explosive,
                                      bool vod_typed);

/// An explosive of the table as it detonates here. InputError as ExplosiveTable::find().
[[nodiscard]] NamedExplosive table_explosive(const ChargeOptions& options, const std::string& name,
                                             const std::string& where);

/// P0 of an explosive by the chosen model, or as typed [Pa]. InputError if the model needs what the
/// explosive lacks, or density or VOD is outside the range that the formulas are made for.
[[nodiscard]] double initial_pressure(const ChargeOptions& options,
                                      const NamedExplosive& explosive);

/// One number per model that this explosive allows, for the log: "explosion state 2784, ..." [MPa].
[[nodiscard]] std::string alternative_pressures(const ChargeOptions& options,
                                                const NamedExplosive& explosive);

/// Decoupling in rock where the peak falls with this exponent: that of stemming, which is crushed
/// rock, unless one is typed.
[[nodiscard]] DecouplingRule decoupling_rule(const ChargeOptions& options,
                                             double attenuation_exponent);

/// The law by which the products expand, from P0; its gas stage by a typed pressure or share, else
/// by stage_by_crushing(). InputError as the law, as initial_pressure() and
/// energy_switch_pressure(), or if something of the explosive that the law needs is not known.
[[nodiscard]] ProductExpansion product_expansion(const ChargeOptions& options,
                                                 const NamedExplosive& explosive);

/// Whether the gas stage starts where the gas has come down to the peak on the wall of the crushed
/// zone, rather than as typed or where the law itself changes.
[[nodiscard]] bool stage_by_crushing(const ChargeOptions& options);

}  // namespace muckpile
