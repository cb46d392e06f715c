// SPDX-License-Identifier: GPL-2.0-or-later
// The words of fix muckpile/blast; see the header.
#include "explosive/blast_options.h"

#include <numbers>
#include <sstream>

#include "args/input_error.h"
#include "args/numbers.h"
#include "explosive/attenuation.h"

namespace muckpile {
namespace {

constexpr const char* kNotGiven = "auto";

/// A number that may be left to the style: a word in the table, read by optional_real().
void add_optional(ArgTable& table, const std::string& name, const std::string& text) {
  table.word(name, {}, kNotGiven, text);
}

std::optional<double> optional_real(const ArgValues& values, const std::string& where,
                                    const std::string& name, const std::string& unit, Range range) {
  const std::string& word = values.word(name);
  if (word == kNotGiven) return std::nullopt;
  return parse_real(where, name, word, unit, range);
}

void add_charge_keywords(ArgTable& table) {
  table.real("explosive_density", "kg/m3", Range::positive(), std::nullopt, "density of the charge")
      .real("vod", "m/s", Range::positive(), std::nullopt, "detonation velocity along the column")
      .real("hole_diameter", "m", Range::positive(), std::nullopt,
            "diameter of hole and charge (fully coupled)")
      .word("borehole_model",
            {"explosion_state", "explosion_state_fit", "chapman_jouguet", "impedance_matched"},
            "explosion_state", "formula for the borehole pressure P0");
  add_optional(table, "borehole_pressure", "P0 itself [Pa], > 0; auto: from borehole_model");
  add_optional(table, "rock_impedance",
               "density times P-wave speed of the rock [Pa s/m], > 0; needed by impedance_matched "
               "only");
  table.word("primer", {}, "bottom", "bottom, top, or its place along the column from 0 to 1");
}

void add_pulse_keywords(ArgTable& table) {
  table.flag("pulse", true, "stress-wave pulse on or off")
      .real("rise_time", "s", Range::positive(), 1e-4, "time from arrival to peak");
  add_optional(table, "poisson_ratio",
               "of the rock, >= 0 and < 0.5; sets the attenuation exponent 2 + nu/(1 - nu)");
  add_optional(table, "attenuation_exponent",
               "from hole wall to crushed-zone wall, >= 0; auto: from poisson_ratio");
  add_optional(table, "peak_pressure",
               "P1 on the crushed-zone wall itself [Pa], >= 0; auto: P0 attenuated");
}

void add_gas_keywords(ArgTable& table) {
  table.flag("gas", true, "gas stage on or off")
      .real("gas_switch_pressure", "Pa", Range::positive(), 200e6,
            "pressure p_k at which the isentrope changes its exponent and the gas stage starts")
      .real("gas_gamma_dense", "", Range::positive(), 3.0, "isentrope exponent above p_k")
      .real("gas_gamma", "", Range::positive(), 1.4, "isentrope exponent below p_k");
  add_optional(table, "vent_time",
               "from firing to the start of venting [s], >= 0; needed with gas yes, about 3.3e-3 "
               "per m of burden");
  add_optional(
      table, "vent_decay",
      "decay time of the gas once it vents [s], > 0; needed with gas yes, about 1.5e-3 per "
      "m of burden");
}

void add_timing_keywords(ArgTable& table) {
  table
      .real("interval", "s", Range::non_negative(), 0.0,
            "between the firing of consecutive holes, the first at 0")
      .group("hole", 3, 3, true, "N delay SECONDS: this hole's own firing time");
}

[[noreturn]] void refuse(const std::string& where, const std::string& text) {
  throw InputError(where + ": " + text);
}

double primer_place(const std::string& where, const std::string& word) {
  if (word == "bottom") return 0.0;
  if (word == "top") return 1.0;
  try {
    return parse_real(where, "primer", word, "", Range::closed(0.0, 1.0));
  } catch (const InputError&) {
    refuse(where, "primer must be bottom, top or a number from 0 to 1, got '" + word + "'");
  }
}

double chosen_borehole_pressure(const BlastOptions& options, const ArgValues& values) {
  const std::string& model = values.word("borehole_model");
  if (const auto typed =
          optional_real(values, options.where, "borehole_pressure", "Pa", Range::positive())) {
    if (!values.given("borehole_model")) return *typed;
    refuse(options.where, "borehole_pressure and borehole_model exclude each other");
  }
  if (model == "explosion_state_fit") return explosion_state_pressure_fit(options.explosive);
  if (model == "chapman_jouguet") return chapman_jouguet_pressure(options.explosive);
  if (model == "impedance_matched") {
    if (!options.rock_impedance) {
      refuse(options.where, "borehole_model impedance_matched needs rock_impedance [Pa s/m]");
    }
    return impedance_matched_pressure(options.explosive, *options.rock_impedance);
  }
  return explosion_state_pressure(options.explosive);
}

double chosen_exponent(const BlastOptions& options, const ArgValues& values) {
  const auto poisson_ratio =
      optional_real(values, options.where, "poisson_ratio", "", Range::right_open(0.0, 0.5));
  if (const auto typed =
          optional_real(values, options.where, "attenuation_exponent", "", Range::non_negative())) {
    return *typed;
  }
  if (poisson_ratio) return crushed_zone_exponent(*poisson_ratio);
  if (options.peak_pressure || !options.pulse) return 0.0;  // not used
  refuse(options.where, "needs poisson_ratio, attenuation_exponent or peak_pressure");
}

/// A time that the gas needs; `advice` for who left it out.
double vent_word(const BlastOptions& options, const ArgValues& values, const std::string& name,
                 Range range, const std::string& advice) {
  const auto typed = optional_real(values, options.where, name, "s", range);
  if (typed) return *typed;
  if (options.gas) {
    refuse(options.where,
           name + " [s] is needed with gas yes (about " + advice + " s per metre of burden)");
  }
  return 1.0;  // not used
}

std::map<long, double> own_delays(const std::string& where, const ArgValues& values) {
  std::map<long, double> delays;
  for (const std::vector<std::string>& words : values.groups("hole")) {
    const long number = parse_integer(where, "hole", words[0], "", Range::any());
    if (words[1] != "delay") {
      refuse(where, "hole " + words[0] + " must be followed by delay, got '" + words[1] + "'");
    }
    const double delay =
        parse_real(where, "hole " + words[0] + " delay", words[2], "s", Range::non_negative());
    if (!delays.emplace(number, delay).second) {
      refuse(where, "hole " + words[0] + " is given twice");
    }
  }
  return delays;
}

double charge_volume(const BlastOptions& options, const Hole& zone) {
  return std::numbers::pi * options.hole_radius * options.hole_radius *
         (zone.collar - zone.toe).norm();
}

double wall_peak(const BlastOptions& options, const Hole& zone) {
  if (!options.pulse) return 0.0;
  if (options.peak_pressure) return *options.peak_pressure;
  return attenuated_pressure(options.borehole_pressure, options.hole_radius, zone.radius,
                             options.attenuation_exponent);
}

HoleBlast hole_blast(const BlastOptions& options, const Hole& zone, int index) {
  if (zone.radius < options.hole_radius) {
    std::ostringstream text;
    text << "hole_diameter must not exceed that of the crushed zone of hole " << index + 1 << ", "
         << 2.0 * zone.radius << " [m], got '" << 2.0 * options.hole_radius << "'";
    refuse(options.where, text.str());
  }
  const auto own = options.delays.find(index + 1);
  const double firing = own != options.delays.end() ? own->second : index * options.interval;
  try {
    return {BlastLoad({.wave_peak = wall_peak(options, zone),
                       .rise_time = options.rise_time,
                       .gas = options.gas,
                       .isentrope = options.isentrope,
                       .charge_volume = charge_volume(options, zone),
                       .vent_time = options.vent_time,
                       .vent_decay = options.vent_decay}),
            DetonationFront({.toe = zone.toe,
                             .collar = zone.collar,
                             .detonation_velocity = options.explosive.detonation_velocity,
                             .firing_time = firing,
                             .primer = options.primer})};
  } catch (const InputError& error) {
    refuse(options.where, "hole " + std::to_string(index + 1) + ": " + error.what());
  }
}

}  // namespace

ArgTable blast_table() {
  ArgTable table("fix muckpile/blast");
  add_charge_keywords(table);
  add_pulse_keywords(table);
  add_gas_keywords(table);
  add_timing_keywords(table);
  return table;
}

BlastOptions blast_options(const ArgValues& values, const std::string& where) {
  BlastOptions options;
  options.where = where;
  options.pulse = values.flag("pulse");
  options.gas = values.flag("gas");
  if (!options.pulse && !options.gas) refuse(where, "pulse no and gas no leave no load");
  options.explosive = {values.real("explosive_density"), values.real("vod")};
  options.hole_radius = 0.5 * values.real("hole_diameter");
  options.rock_impedance =
      optional_real(values, where, "rock_impedance", "Pa s/m", Range::positive());
  options.borehole_pressure = chosen_borehole_pressure(options, values);
  options.peak_pressure =
      optional_real(values, where, "peak_pressure", "Pa", Range::non_negative());
  options.attenuation_exponent = chosen_exponent(options, values);
  options.rise_time = values.real("rise_time");
  options.isentrope = {.initial_pressure = options.borehole_pressure,
                       .switch_pressure = values.real("gas_switch_pressure"),
                       .dense_exponent = values.real("gas_gamma_dense"),
                       .dilute_exponent = values.real("gas_gamma")};
  options.vent_time = vent_word(options, values, "vent_time", Range::non_negative(), "3.3e-3");
  options.vent_decay = vent_word(options, values, "vent_decay", Range::positive(), "1.5e-3");
  options.primer = primer_place(where, values.word("primer"));
  options.interval = values.real("interval");
  options.delays = own_delays(where, values);
  return options;
}

std::vector<HoleBlast> hole_blasts(const BlastOptions& options,
                                   const std::vector<Hole>& crushed_zones) {
  const int count = static_cast<int>(crushed_zones.size());
  if (count == 0) refuse(options.where, "there is no hole to load; give create_blocks a hole");
  for (const auto& [number, delay] : options.delays) {
    if (number >= 1 && number <= count) continue;
    refuse(options.where, "hole must be from 1 to " + std::to_string(count) +
                              ", the holes of create_blocks, got '" + std::to_string(number) + "'");
  }
  std::vector<HoleBlast> blasts;
  for (int i = 0; i < count; ++i) {
    blasts.push_back(hole_blast(options, crushed_zones[static_cast<std::size_t>(i)], i));
  }
  return blasts;
}

std::string describe(const BlastOptions& options, const std::vector<Hole>& crushed_zones,
                     const std::vector<HoleBlast>& blasts) {
  constexpr double kMPa = 1e6;
  const Hole& zone = crushed_zones.front();
  const BlastLoad& load = blasts.front().load();
  std::ostringstream text;
  text.precision(4);
  text << options.where << ": " << blasts.size() << " hole(s), hole 1:\n"
       << "  borehole pressure P0 = " << options.borehole_pressure / kMPa
       << " MPa; other formulas: explosion state "
       << explosion_state_pressure(options.explosive) / kMPa << ", its fit "
       << explosion_state_pressure_fit(options.explosive) / kMPa << ", Chapman-Jouguet "
       << chapman_jouguet_pressure(options.explosive) / kMPa;
  if (options.rock_impedance) {
    text << ", impedance-matched "
         << impedance_matched_pressure(options.explosive, *options.rock_impedance) / kMPa;
  }
  text << " MPa\n  wave peak P1 = " << load.wave_peak() / kMPa << " MPa on r1 = " << zone.radius
       << " m (" << zone.radius / options.hole_radius << " hole radii, exponent "
       << options.attenuation_exponent << "), rise " << options.rise_time << " s\n";
  if (options.gas) {
    text << "  gas from " << load.gas_pressure(0.0, 0.0) / kMPa
         << " MPa at Vk = " << load.switch_volume()
         << " m3, charge volume V0 = " << charge_volume(options, zone) << " m3, vents after "
         << options.vent_time << " s, decay " << options.vent_decay << " s\n";
  }
  text << "  firing times [s]:";
  for (const HoleBlast& blast : blasts) text << ' ' << blast.firing_time();
  text << '\n';
  return text.str();
}

}  // namespace muckpile
