// SPDX-License-Identifier: GPL-2.0-or-later
// The words of fix muckpile/blast; see the header.
#include "explosive/blast_options.h"

#include <algorithm>
#include <initializer_list>
#include <map>
#include <string>

#include "args/input_error.h"
#include "args/numbers.h"

namespace muckpile {
namespace {

void add_charge_keywords(ArgTable& table) {
  add_explosive_keywords(table);
  add_optional(table, "hole_diameter", "of all holes [m], 1e-3 to 10; needed without hole_table");
  table.word("hole_table", {}, "none",
             "CSV file of the pattern, as create_blocks has it: each hole's diameter, charge, "
             "explosive and firing time");
  add_decoupling_keywords(table);
  add_borehole_keywords(table);
  table.word("primer", {}, "bottom", "bottom, top, or its place along the charge from 0 to 1");
}

void add_pulse_keywords(ArgTable& table) {
  std::vector<std::string> shapes;
  for (const auto& [name, kind] : pulse_kinds()) shapes.push_back(name);
  table.flag("pulse", true, "stress-wave pulse on or off")
      .real("rise_time", "s", Range::left_open(0.0, 1.0), 1e-4,
            "time from arrival to peak; not of `table`")
      .word("pulse_shape", shapes, "starfield",
            "history of the pulse; jong is starfield with this rise time")
      .real("pulse_ratio", "", Range::left_open(1.0, 1e3), 2.0,
            "rates' ratio of `duvall`; 2 is starfield");
  add_optional(table, "pulse_end", "end of `triangular` [s], > rise_time and <= 10");
  add_optional(table, "pulse_half_time", "of `itasca` after the peak [s], > 0 and <= 10");
  table.word("pulse_table", {}, "none", "CSV file of `table`: columns time_s, share of P1");
  add_attenuation_keywords(table, {"shock", "liu_katsabanis"},
                           "that of a shock, 2 + nu/(1 - nu), or 1.54 (c_p/D)^-0.33");
  add_optional(table, "poisson_ratio", "of the rock, >= 0 and < 0.5; needed by attenuation shock");
  add_optional(table, "rock_p_wave_speed",
               "c_p of the rock [m/s], 100 to 2e4; needed by attenuation liu_katsabanis");
  add_optional(table, "peak_pressure",
               "P1 on the crushed-zone wall itself [Pa], 1e5 to 1e12, from which the gas stage "
               "starts, too; auto: P0 attenuated");
}

void add_gas_keywords(ArgTable& table) {
  table.flag("gas", true, "gas stage on or off");
  add_expansion_keywords(table);
  add_optional(
      table, "vent_time",
      "from firing to the start of venting [s], 0 to 60; needed with gas yes, about 3.3e-3 "
      "per m of burden");
  add_optional(table, "vent_decay",
               "decay time of the gas once it vents [s], > 0 and <= 60; needed with gas yes, about "
               "1.5e-3 per "
               "m of burden");
}

void add_venting_keywords(ArgTable& table) {
  table.real("crushed_friction", "deg", Range::right_open(0.0, 90.0), 0.0,
             "friction angle of crushed rock, through which the gas presses; 0: it presses on the "
             "wall of the crushed zone itself");
  table.word("venting", {"time", "flow"}, "time",
             "how the gas leaves: by the two times above, or by flow through collar and cracks");
  add_optional(table, "stemming_length", "[m], 0 to 1e6; needed with venting flow");
  table
      .real("stemming_density", "kg/m3", Range::closed(100.0, 30000.0), 1800.0,
            "of the stemming, as it lies")
      .real("stemming_shear", "Pa", Range::closed(0.0, 1e9), 0.0,
            "resistance of the stemming per area of the hole's wall")
      .real("stemming_grain", "m", Range::closed(0.0, 0.1), 0.0,
            "size of the stones of the stemming, between which gas leaks, at a stemming_density "
            "below "
            "2650; 0: none does")
      .real("collar_discharge", "", Range::closed(0.0, 1.0), 0.8,
            "share of the choked flow through the open collar");
  add_optional(
      table, "crack_delay",
      "from firing until cracks reach a free face [s], 0 to 60, about 1e-3 per m of burden; "
      "needed with venting flow");
  table.real("crack_discharge", "", Range::closed(0.0, 1.0), 0.05,
             "share of the choked flow through the cracks at the wall");
}

void add_timing_keywords(ArgTable& table) {
  table
      .real("interval", "s", delay_range(), 0.0,
            "between the firing of consecutive holes, the first at 0")
      .group("hole", 3, 3, true, "N delay SECONDS: this hole's own firing time");
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

void read_attenuation(BlastOptions& options, const ArgValues& values) {
  const auto number = [&](const char* name, const char* unit, Range range) {
    return optional_real(values, options.where, name, unit, range);
  };
  options.poisson_ratio = number("poisson_ratio", "", Range::right_open(0.0, 0.5));
  options.p_wave_speed = number("rock_p_wave_speed", "m/s", Range::closed(100.0, 2e4));
  options.exponent = read_attenuation_exponent(values, options.where, Range::closed(0.0, 10.0));
  options.peak_pressure = number("peak_pressure", "Pa", Range::closed(1e5, 1e12));
  if (!options.exponent) {
    static const std::map<std::string, Attenuation> kLaws{
        {"shock", Attenuation::shock}, {"liu_katsabanis", Attenuation::liu_katsabanis}};
    options.attenuation = kLaws.at(values.word("attenuation"));
  }
  const bool stage_needs_it = options.gas && stage_by_crushing(options.charge);
  if (options.peak_pressure || !(options.pulse || stage_needs_it)) return;
  if (options.attenuation == Attenuation::shock && !options.poisson_ratio) {
    refuse(options.where, "attenuation shock needs poisson_ratio");
  }
  if (options.attenuation == Attenuation::liu_katsabanis && !options.p_wave_speed) {
    refuse(options.where, "attenuation liu_katsabanis needs rock_p_wave_speed [m/s]");
  }
}

/// A number that this way of venting needs; `advice` for who left it out.
std::optional<double> vent_word(const BlastOptions& options, const ArgValues& values,
                                const std::string& name, const std::string& unit, Range range,
                                bool by_flow, const std::string& advice) {
  const auto typed = optional_real(values, options.where, name, unit, range);
  if (!typed && options.gas && options.vent_by_flow == by_flow) {
    refuse(options.where, name + " [" + unit + "] is needed with gas yes" + advice);
  }
  return typed;
}

void read_venting(BlastOptions& options, const ArgValues& values) {
  options.vent_by_flow = values.word("venting") == "flow";
  options.vent_time = vent_word(options, values, "vent_time", "s", delay_range(), false,
                                " (about 3.3e-3 s per metre of burden)");
  options.vent_decay = vent_word(options, values, "vent_decay", "s", Range::left_open(0.0, 60.0),
                                 false, " (about 1.5e-3 s per metre of burden)");
  options.flow.stemming_length = vent_word(options, values, "stemming_length", "m",
                                           Range::closed(0.0, 1e6), true, " and venting flow")
                                     .value_or(0.0);
  options.flow.crack_delay = vent_word(options, values, "crack_delay", "s", delay_range(), true,
                                       " and venting flow (about 1e-3 s per metre of burden)")
                                 .value_or(0.0);
  options.crushed_friction = values.real("crushed_friction") * M_PI / 180.0;
  options.flow.stemming_density = values.real("stemming_density");
  options.flow.stemming_shear = values.real("stemming_shear");
  options.flow.stemming_grain = values.real("stemming_grain");
  options.flow.collar_discharge = values.real("collar_discharge");
  options.flow.crack_discharge = values.real("crack_discharge");
}

void read_pulse(BlastOptions& options, const ArgValues& values) {
  using Kind = PulseParameters::Kind;
  PulseParameters& pulse = options.pulse_shape;
  for (const auto& [name, kind] : pulse_kinds()) {
    if (name == values.word("pulse_shape")) pulse.kind = kind;
  }
  pulse.rise_time = values.real("rise_time");
  pulse.ratio = values.real("pulse_ratio");
  const auto needed = [&](std::initializer_list<Kind> kinds, const char* name) {
    const auto typed = optional_real(values, options.where, name, "s", Range::left_open(0.0, 10.0));
    if (!typed && std::ranges::find(kinds, pulse.kind) != kinds.end()) {
      refuse(options.where,
             std::string(name) + " [s] is needed with pulse_shape " + values.word("pulse_shape"));
    }
    return typed.value_or(0.0);
  };
  pulse.end_time = needed({Kind::triangular}, "pulse_end");
  pulse.half_time = needed({Kind::itasca}, "pulse_half_time");
  if (pulse.kind == Kind::table) {
    if (values.word("pulse_table") == "none")
      refuse(options.where, "pulse_table, a CSV file, is needed with pulse_shape table");
    pulse.table = read_pulse_table(values.word("pulse_table"));
  }
  try {
    pulse.rise_time = PulseShape(pulse).rise_time();
  } catch (const InputError& error) {
    refuse(options.where, error.what());
  }
}

void read_holes(BlastOptions& options, const ArgValues& values) {
  const auto diameter =
      optional_real(values, options.where, "hole_diameter", "m", Range::closed(1e-3, 10.0));
  const std::string& file = values.word("hole_table");
  if (file == "none") {
    if (!diameter) refuse(options.where, "needs hole_diameter [m] or hole_table");
    options.charge.hole_radius = 0.5 * *diameter;
    return;
  }
  for (const char* word : {"hole_diameter", "interval"}) {
    if (values.given(word)) refuse(options.where, std::string("hole_table excludes ") + word);
  }
  if (!values.groups("hole").empty()) refuse(options.where, "hole_table excludes hole");
  options.pattern = HoleTable::read(file);
}

std::map<long, double> own_delays(const std::string& where, const ArgValues& values) {
  std::map<long, double> delays;
  for (const std::vector<std::string>& words : values.groups("hole")) {
    const long number = parse_integer(where, "hole", words[0], "", Range::any());
    if (words[1] != "delay") {
      refuse(where, "hole " + words[0] + " must be followed by delay, got '" + words[1] + "'");
    }
    const double delay =
        parse_real(where, "hole " + words[0] + " delay", words[2], "s", delay_range());
    if (!delays.emplace(number, delay).second) {
      refuse(where, "hole " + words[0] + " is given twice");
    }
  }
  return delays;
}

}  // namespace

ArgTable blast_table() {
  ArgTable table("fix muckpile/blast");
  add_charge_keywords(table);
  add_pulse_keywords(table);
  add_gas_keywords(table);
  add_venting_keywords(table);
  add_timing_keywords(table);
  return table;
}

BlastOptions blast_options(const ArgValues& values, const std::string& where) {
  BlastOptions options;
  options.where = where;
  options.pulse = values.flag("pulse");
  options.gas = values.flag("gas");
  if (!options.pulse && !options.gas) refuse(where, "pulse no and gas no leave no load");
  read_explosive(options.charge, values, where);
  read_holes(options, values);
  read_decoupling(options.charge, values, where);
  read_expansion(options.charge, values, where);
  read_attenuation(options, values);
  read_pulse(options, values);
  read_venting(options, values);
  options.primer = primer_place(where, values.word("primer"));
  options.interval = values.real("interval");
  options.delays = own_delays(where, values);
  return options;
}

}  // namespace muckpile
