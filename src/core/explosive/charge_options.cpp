// SPDX-License-Identifier: GPL-2.0-or-later
// The words of a charge; see the header.
#include "explosive/charge_options.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

#include "args/input_error.h"
#include "args/numbers.h"
#include "args/require.h"
#include "explosive/attenuation.h"

namespace muckpile {
namespace {

constexpr const char* kNotGiven = "auto";
constexpr const char* kByExponent = "exponent";
constexpr double kAtOnce =
    1e20;  // a detonation velocity that fires the whole charge in no time [m/s]

const std::vector<std::string> kModels = {"explosion_state",       "explosion_state_fit",
                                          "explosion_state_gamma", "chapman_jouguet",
                                          "impedance_matched",     "jwl"};

const std::vector<std::string> kExpansions = {"two_stage", "jwl", "covolume",
                                              kNotGiven};  // in the order of Expansion

const std::vector<std::string> kAirGaps = {"energy", "isentrope", "power"};  // order of AirGap

JwlParameters typed_jwl(const std::string& where, const std::vector<std::string>& words,
                        const NamedExplosive& explosive) {
  struct Word {
    const char *name, *unit;
    Range range;
  };
  // Around all sets of explosives that detonate: A of 4e10 to 1e12 Pa, B of 1e8 to 1e11 Pa, R1 of 3
  // to 8, R2 of 0.5 to 2, omega of 0.1 to 0.6 (Dobratz and Crawford 1985); values in GPa are far
  // outside.
  static const std::array<Word, 6> kWords{{{"jwl A", "Pa", Range::closed(1e8, 1e13)},
                                           {"jwl B", "Pa", Range::closed(0.0, 1e12)},
                                           {"jwl R1", "", Range::closed(0.5, 20.0)},
                                           {"jwl R2", "", Range::closed(0.0, 10.0)},
                                           {"jwl omega", "", Range::closed(0.01, 2.0)},
                                           {"jwl P_CJ", "Pa", Range::closed(1e8, 1e12)}}};
  std::array<double, 6> v{};
  for (std::size_t k = 0; k < v.size(); ++k)
    v[k] = parse_real(where, kWords[k].name, words[k], kWords[k].unit, kWords[k].range);
  return {.a = v[0],
          .b = v[1],
          .r1 = v[2],
          .r2 = v[3],
          .omega = v[4],
          .cj_pressure = v[5],
          .density = explosive.density,
          .detonation_velocity = explosive.detonation_velocity};
}

}  // namespace

void add_optional(ArgTable& table, const std::string& name, const std::string& text) {
  table.word(name, {}, kNotGiven, text);
}

std::optional<double> optional_real(const ArgValues& values, const std::string& where,
                                    const std::string& name, const std::string& unit, Range range) {
  const std::string& word = values.word(name);
  if (word == kNotGiven) return std::nullopt;
  return parse_real(where, name, word, unit, range);
}

void add_explosive_keywords(ArgTable& table) {
  table.word("explosive", {}, "none",
             "name in the table of explosives; none: the numbers below are needed");
  table.word("explosive_table", {}, "none",
             "CSV file with explosives of your own, in the columns of the shipped explosives.csv; "
             "its names win");
  add_optional(table, "explosive_density",
               "density of the charge [kg/m3], 10 to 1e4; auto: the table's");
  add_optional(
      table, "vod",
      "detonation velocity along the column [m/s], >= 100 (1e20: all at once); auto: the table's");
  add_optional(table, "explosive_energy",
               "heat of explosion per mass [J/kg], 1e4 to 1e9; auto: the table's");
  add_optional(table, "energy_share",
               "share of the charge that reacts in time, with its energy and its gas, > 0 and <= "
               "1, for a non-ideal detonation; vod of the table is multiplied by its square root, "
               "a typed one is not; auto: 1");
  add_optional(
      table, "explosive_gamma",
      "exponent of the products at the Chapman-Jouguet point, > 1 and <= 10; auto: the table's");
  add_optional(table, "gas_volume",
               "products per mass as a gas at 273.15 K and 101325 Pa, water as steam [m3/kg], 0.1 "
               "to 2; auto: the table's, 0.9 without");
  table.group("jwl", 6, 6, false,
              "A [Pa] B [Pa] R1 R2 omega P_CJ [Pa] of an explosive of this density and VOD");
}

void add_borehole_keywords(ArgTable& table) {
  table.word("borehole_model", kModels, "explosion_state", "formula for the borehole pressure P0");
  add_optional(table, "borehole_pressure",
               "P0 itself [Pa], 1e5 to 1e12; auto: from borehole_model");
  add_optional(
      table, "rock_impedance",
      "density times P-wave speed of the rock [Pa s/m], 1e3 to 1e9; needed by impedance_matched "
      "only");
}

void add_decoupling_keywords(ArgTable& table) {
  add_optional(
      table, "charge_diameter",
      "diameter of the charge [m], 1e-3 to 10, at most hole_diameter; auto: it fills the hole");
  add_optional(table, "charge_length",
               "length of the charge [m], > 0 and <= 1000, from its toe; what is left of the "
               "hole's axis is an "
               "air deck; auto: the whole axis");
  table.word("coupling", {kCouplings.begin(), kCouplings.end()}, kCouplings.front(),
             "what stands around a charge thinner than its hole");
  add_optional(table, "coupling_exponent",
               "decay of the peak through water or stemming, 0 to 10; auto: 0.72 in water, the "
               "attenuation exponent in stemming");
  table
      .word("decoupling", kAirGaps, kAirGaps.front(),
            "fall of the pressure into an air gap: products that fill it without work and keep "
            "their energy, along the isentrope, or one power law")
      .real("decoupling_exponent", "", Range::left_open(0.0, 10.0), 3.0,
            "of the power law in volume: 3 is the usual sixth power of the diameters")
      .real("impact_factor", "", Range::closed(1.0, 11.0), 1.0,
            "shock of the products on the wall behind an air gap over their pressure; on the wave "
            "only");
}

void add_attenuation_keywords(ArgTable& table, std::vector<std::string> laws,
                              const std::string& text) {
  laws.insert(laws.begin(), kByExponent);
  table.word("attenuation", laws, kByExponent,
             "by which the peak of the wave falls from hole wall to crushed-zone wall: "
             "attenuation_exponent, " +
                 text);
  add_optional(table, "attenuation_exponent",
               "exponent of that fall, at most 10; auto: 1.5, of a stress wave");
}

void add_expansion_keywords(ArgTable& table) {
  table
      .word("expansion", kExpansions, kNotGiven,
            "law by which the products expand; auto: covolume, or two_stage where the explosive's "
            "energy is not known or gas_gamma_dense is given")
      .word("gas_switch_pressure", {}, "energy",
            "pressure p_k at which the gas stage starts and the isentrope of two_stage changes its "
            "exponent [Pa], 1e5 to 1e12; energy: by the energy of the explosive and, of jwl and "
            "covolume, what crushing takes (200e6 where that energy is not known)")
      .word(
          "dense_share", {}, kNotGiven,
          "share of the products' energy that is spent as the gas stage of a charge that fills its "
          "hole starts, >= 0 and < 1, with gas_switch_pressure energy (jwl, covolume); auto: "
          "until it presses what the wave does on the wall of the crushed zone")
      .real("gas_gamma_dense", "", Range::closed(1.0, 10.0), 3.0,
            "isentrope exponent above p_k (two_stage)")
      .real("gas_gamma", "", Range::closed(1.0, 10.0), 1.4,
            "isentrope exponent below p_k (two_stage), of all (covolume)");
}

void read_explosive(ChargeOptions& options, const ArgValues& values, const std::string& where) {
  options.table = ExplosiveTable::with_file(values.word("explosive_table"));
  NamedExplosive& explosive = options.explosive;
  const bool named = values.word("explosive") != "none";
  if (named) explosive = options.table.find(values.word("explosive"), where);
  const auto typed = [&](const char* name, const char* unit, Range range) {
    return optional_real(values, where, name, unit, range);
  };
  const auto density = typed("explosive_density", "kg/m3", Range::closed(10.0, 1e4));
  const auto velocity = typed("vod", "m/s", Range::closed(100.0, kAtOnce));
  const auto energy = typed("explosive_energy", "J/kg", Range::closed(1e4, 1e9));
  if (!named && !(density && velocity)) {
    refuse(where, "needs explosive NAME, or explosive_density and vod");
  }
  if (!named) explosive.name = "as typed";
  explosive.density = density.value_or(explosive.density);
  explosive.detonation_velocity = velocity.value_or(explosive.detonation_velocity);
  explosive.energy = energy.value_or(explosive.energy);
  options.energy_known = named || energy;
  options.energy_share =
      typed("energy_share", "", Range::left_open(0.0, 1.0)).value_or(options.energy_share);
  explosive = released(options, explosive, velocity.has_value());
  if (const auto gamma = typed("explosive_gamma", "", Range::left_open(1.0, 10.0))) {
    explosive.gamma = gamma;
  }
  explosive.gas_volume = typed("gas_volume", "m3/kg", kGasVolumes).value_or(explosive.gas_volume);
  if (!values.groups("jwl").empty()) {
    explosive.jwl = typed_jwl(where, values.groups("jwl").front(), explosive);
  }
  options.typed_pressure =
      optional_real(values, where, "borehole_pressure", "Pa", Range::closed(1e5, 1e12));
  if (options.typed_pressure && values.given("borehole_model")) {
    refuse(where, "borehole_pressure and borehole_model exclude each other");
  }
  options.rock_impedance =
      optional_real(values, where, "rock_impedance", "Pa s/m", Range::closed(1e3, 1e9));
  const auto at = std::find(kModels.begin(), kModels.end(), values.word("borehole_model"));
  options.model = static_cast<BoreholeModel>(at - kModels.begin());
}

void read_decoupling(ChargeOptions& options, const ArgValues& values, const std::string& where) {
  if (const auto diameter =
          optional_real(values, where, "charge_diameter", "m", Range::closed(1e-3, 10.0))) {
    options.charge_radius = 0.5 * *diameter;
  }
  options.charge_length =
      optional_real(values, where, "charge_length", "m", Range::left_open(0.0, 1e3));
  DecouplingRule& rule = options.decoupling;
  const auto coupling = std::find(kCouplings.begin(), kCouplings.end(), values.word("coupling"));
  rule.coupling = static_cast<Coupling>(coupling - kCouplings.begin());
  const auto gap = std::find(kAirGaps.begin(), kAirGaps.end(), values.word("decoupling"));
  rule.air_gap = static_cast<AirGap>(gap - kAirGaps.begin());
  rule.power_exponent = values.real("decoupling_exponent");
  rule.impact_factor = values.real("impact_factor");
  if (const auto exponent =
          optional_real(values, where, "coupling_exponent", "", Range::closed(0.0, 10.0))) {
    rule.coupling_exponent = *exponent;
    options.coupling_exponent_typed = true;
  }
}

/// The law as typed. Only two stages do without the explosive's energy, and only they have an
/// exponent of the dense products.
Expansion expansion_of(const ChargeOptions& options, const ArgValues& values) {
  if (values.word("expansion") == kNotGiven) {
    const bool two_stage = !options.energy_known || values.given("gas_gamma_dense");
    return two_stage ? Expansion::two_stage : Expansion::covolume;
  }
  const auto at = std::find(kExpansions.begin(), kExpansions.end(), values.word("expansion"));
  return static_cast<Expansion>(at - kExpansions.begin());
}

void read_expansion(ChargeOptions& options, const ArgValues& values, const std::string& where) {
  options.expansion = expansion_of(options, values);
  if (values.given("gas_gamma_dense") && options.expansion != Expansion::two_stage) {
    refuse(where, "gas_gamma_dense needs expansion two_stage");
  }
  const bool jwl = options.expansion == Expansion::jwl;
  // The isentrope has a pressure of its own at the charge's volume.
  if (jwl && !options.typed_pressure && !values.given("borehole_model")) {
    options.model = BoreholeModel::jwl;
  }
  options.switch_by_energy = values.word("gas_switch_pressure") == "energy";
  options.switch_typed = values.given("gas_switch_pressure");
  if (!options.switch_by_energy) {
    options.isentrope.switch_pressure =
        parse_real(where, "gas_switch_pressure", values.word("gas_switch_pressure"), "Pa",
                   Range::closed(1e5, 1e12));
  }
  options.dense_share =
      optional_real(values, where, "dense_share", "", Range::right_open(0.0, 1.0));
  if (options.dense_share &&
      (options.expansion == Expansion::two_stage || !options.switch_by_energy)) {
    refuse(where, "dense_share needs expansion covolume or jwl, and gas_switch_pressure energy");
  }
  options.isentrope.dense_exponent = values.real("gas_gamma_dense");
  options.isentrope.dilute_exponent = values.real("gas_gamma");
}

std::optional<double> read_attenuation_exponent(const ArgValues& values, const std::string& where,
                                                Range range) {
  const auto typed = optional_real(values, where, "attenuation_exponent", "", range);
  const std::string& law = values.word("attenuation");
  if (law == kByExponent) return typed.value_or(kStressWaveExponent);
  if (typed) refuse(where, "attenuation_exponent and attenuation " + law + " exclude each other");
  return std::nullopt;
}

}  // namespace muckpile
