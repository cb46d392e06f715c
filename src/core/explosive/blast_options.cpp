// SPDX-License-Identifier: GPL-2.0-or-later
// The words of fix muckpile/blast; see the header.
#include "explosive/blast_options.h"

#include <sstream>

#include "args/input_error.h"
#include "args/numbers.h"
#include "explosive/attenuation.h"

namespace muckpile {
namespace {

constexpr double kMPa = 1e6;

void add_charge_keywords(ArgTable& table) {
  add_explosive_keywords(table);
  add_optional(table, "hole_diameter", "of all holes [m], > 0; needed without hole_table");
  table.word("hole_table", {}, "none",
             "CSV file of the pattern, as create_blocks has it: each hole's diameter, charge, "
             "explosive and firing time");
  add_decoupling_keywords(table);
  add_borehole_keywords(table);
  table.word("primer", {}, "bottom", "bottom, top, or its place along the charge from 0 to 1");
}

void add_pulse_keywords(ArgTable& table) {
  table.flag("pulse", true, "stress-wave pulse on or off")
      .real("rise_time", "s", Range::positive(), 1e-4, "time from arrival to peak; not of `table`")
      .word("pulse_shape", {"starfield", "jong", "duvall", "triangular", "itasca", "table"},
            "starfield", "history of the pulse; jong is starfield with this rise time")
      .real("pulse_ratio", "", Range::above(1.0), 2.0, "rates' ratio of `duvall`; 2 is starfield");
  add_optional(table, "pulse_end", "end of `triangular` [s], > rise_time");
  add_optional(table, "pulse_half_time", "of `itasca` after the peak [s], > 0");
  table.word("pulse_table", {}, "none", "CSV file of `table`: columns time_s, share of P1");
  add_optional(table, "poisson_ratio", "of the rock, >= 0 and < 0.5; needed by attenuation shock");
  table.word(
      "attenuation", {"shock", "liu_katsabanis"}, "shock",
      "exponent of the fall of the peak from hole wall to crushed-zone wall: of a shock, 2 + "
      "nu/(1 - nu), or 1.54 (c_p/D)^-0.33");
  add_optional(table, "rock_p_wave_speed",
               "c_p of the rock [m/s], > 0; needed by attenuation liu_katsabanis only");
  add_optional(table, "attenuation_exponent", "that exponent itself, >= 0; auto: from attenuation");
  add_optional(table, "peak_pressure",
               "P1 on the crushed-zone wall itself [Pa], >= 0; auto: P0 attenuated");
}

void add_gas_keywords(ArgTable& table) {
  table.flag("gas", true, "gas stage on or off");
  add_expansion_keywords(table);
  add_optional(table, "vent_time",
               "from firing to the start of venting [s], >= 0; needed with gas yes, about 3.3e-3 "
               "per m of burden");
  add_optional(
      table, "vent_decay",
      "decay time of the gas once it vents [s], > 0; needed with gas yes, about 1.5e-3 per "
      "m of burden");
}

void add_venting_keywords(ArgTable& table) {
  table.word("venting", {"time", "flow"}, "time",
             "how the gas leaves: by the two times above, or by flow through collar and cracks");
  add_optional(table, "stemming_length", "[m], >= 0; needed with venting flow");
  table.real("stemming_density", "kg/m3", Range::positive(), 1800.0, "of the stemming, as it lies")
      .real("stemming_shear", "Pa", Range::non_negative(), 0.0,
            "resistance of the stemming per area of the hole's wall")
      .real("collar_discharge", "", Range::closed(0.0, 1.0), 0.8,
            "share of the choked flow through the open collar");
  add_optional(table, "crack_delay",
               "from firing until cracks reach a free face [s], >= 0, about 1e-3 per m of burden; "
               "needed with venting flow");
  table.real("crack_discharge", "", Range::closed(0.0, 1.0), 0.05,
             "share of the choked flow through the cracks at the wall");
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

void read_attenuation(BlastOptions& options, const ArgValues& values) {
  const auto number = [&](const char* name, const char* unit, Range range) {
    return optional_real(values, options.where, name, unit, range);
  };
  options.poisson_ratio = number("poisson_ratio", "", Range::right_open(0.0, 0.5));
  options.p_wave_speed = number("rock_p_wave_speed", "m/s", Range::positive());
  options.typed_exponent = number("attenuation_exponent", "", Range::non_negative());
  options.peak_pressure = number("peak_pressure", "Pa", Range::non_negative());
  if (values.word("attenuation") == "liu_katsabanis") {
    options.attenuation = Attenuation::liu_katsabanis;
  }
  if (options.typed_exponent && values.given("attenuation")) {
    refuse(options.where, "attenuation_exponent and attenuation exclude each other");
  }
  if (options.typed_exponent) options.attenuation = Attenuation::typed;
  if (options.peak_pressure || !options.pulse) return;
  if (options.attenuation == Attenuation::shock && !options.poisson_ratio) {
    refuse(options.where, "needs poisson_ratio, attenuation_exponent or peak_pressure");
  }
  if (options.attenuation == Attenuation::liu_katsabanis && !options.p_wave_speed) {
    refuse(options.where, "attenuation liu_katsabanis needs rock_p_wave_speed [m/s]");
  }
}

/// Of that explosive; 0 where it is not known because nothing needs it.
double exponent_of(const BlastOptions& options, Attenuation by, const NamedExplosive& explosive) {
  switch (by) {
    case Attenuation::shock:
      return options.poisson_ratio ? crushed_zone_exponent(*options.poisson_ratio) : 0.0;
    case Attenuation::liu_katsabanis:
      return options.p_wave_speed
                 ? liu_katsabanis_exponent(*options.p_wave_speed, explosive.detonation_velocity)
                 : 0.0;
    case Attenuation::typed:
      break;
  }
  return options.typed_exponent.value_or(0.0);
}

/// A number that this way of venting needs; `advice` for who left it out.
double vent_word(const BlastOptions& options, const ArgValues& values, const std::string& name,
                 const std::string& unit, Range range, bool by_flow, const std::string& advice) {
  if (const auto typed = optional_real(values, options.where, name, unit, range)) return *typed;
  if (options.gas && options.vent_by_flow == by_flow) {
    refuse(options.where, name + " [" + unit + "] is needed with gas yes" + advice);
  }
  return 1.0;  // not used
}

void read_venting(BlastOptions& options, const ArgValues& values) {
  options.vent_by_flow = values.word("venting") == "flow";
  options.vent_time = vent_word(options, values, "vent_time", "s", Range::non_negative(), false,
                                " (about 3.3e-3 s per metre of burden)");
  options.vent_decay = vent_word(options, values, "vent_decay", "s", Range::positive(), false,
                                 " (about 1.5e-3 s per metre of burden)");
  options.flow.stemming_length = vent_word(options, values, "stemming_length", "m",
                                           Range::non_negative(), true, " and venting flow");
  options.flow.crack_delay =
      vent_word(options, values, "crack_delay", "s", Range::non_negative(), true,
                " and venting flow (about 1e-3 s per metre of burden)");
  options.flow.gamma = options.charge.isentrope.dilute_exponent;
  options.flow.stemming_density = values.real("stemming_density");
  options.flow.stemming_shear = values.real("stemming_shear");
  options.flow.collar_discharge = values.real("collar_discharge");
  options.flow.crack_discharge = values.real("crack_discharge");
}

void read_pulse(BlastOptions& options, const ArgValues& values) {
  using Kind = PulseParameters::Kind;
  static const std::map<std::string, Kind> kinds = {
      {"starfield", Kind::starfield},   {"jong", Kind::starfield}, {"duvall", Kind::duvall},
      {"triangular", Kind::triangular}, {"itasca", Kind::itasca},  {"table", Kind::table}};
  PulseParameters& pulse = options.pulse_shape;
  pulse.kind = kinds.at(values.word("pulse_shape"));
  pulse.rise_time = values.real("rise_time");
  pulse.ratio = values.real("pulse_ratio");
  const auto needed = [&](Kind kind, const char* name) {
    const auto typed = optional_real(values, options.where, name, "s", Range::positive());
    if (!typed && pulse.kind == kind) {
      refuse(options.where,
             std::string(name) + " [s] is needed with pulse_shape " + values.word("pulse_shape"));
    }
    return typed.value_or(0.0);
  };
  pulse.end_time = needed(Kind::triangular, "pulse_end");
  pulse.half_time = needed(Kind::itasca, "pulse_half_time");
  if (pulse.kind == Kind::table) pulse.table = read_pulse_table(values.word("pulse_table"));
  try {
    pulse.rise_time = PulseShape(pulse).rise_time();
  } catch (const InputError& error) {
    refuse(options.where, error.what());
  }
}

void read_holes(BlastOptions& options, const ArgValues& values) {
  const auto diameter =
      optional_real(values, options.where, "hole_diameter", "m", Range::positive());
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
        parse_real(where, "hole " + words[0] + " delay", words[2], "s", Range::non_negative());
    if (!delays.emplace(number, delay).second) {
      refuse(where, "hole " + words[0] + " is given twice");
    }
  }
  return delays;
}

/// One charge in its hole, all that its load needs.
struct LoadedHole {
  NamedExplosive explosive;
  ChargeShape shape;
  DecouplingRule decoupling;
  double initial_pressure = 0.0;  ///< P0, 0 if nothing needs it [Pa]
  double wall_pressure = 0.0;     ///< on the hole's wall [Pa]
  double exponent = 0.0;          ///< of the attenuation
  bool energy_known = false;      ///< explosive.energy counts
  double primer = 0.0;            ///< 0 toe to 1 collar of the charge
  double firing_time = 0.0;       ///< [s]
};

/// What one row of the pattern says instead of the style's words.
void apply_deck(LoadedHole& hole, const BlastOptions& options, const Deck& deck) {
  if (deck.explosive) {
    hole.explosive = options.charge.table.find(*deck.explosive, "hole_table");
    hole.energy_known = true;
  }
  hole.shape.hole_radius = 0.5 * deck.diameter;
  if (!options.charge.charge_radius) hole.shape.charge_radius = hole.shape.hole_radius;
  if (deck.charge_diameter) hole.shape.charge_radius = 0.5 * *deck.charge_diameter;
  if (deck.charge_length) hole.shape.charge_length = *deck.charge_length;
  if (deck.primer) hole.primer = *deck.primer;
  hole.firing_time = deck.firing_time;
}

LoadedHole loaded_hole(const BlastOptions& options, const Hole& zone, std::size_t index) {
  const ChargeOptions& charge = options.charge;
  LoadedHole hole;
  hole.explosive = charge.explosive;
  hole.energy_known = charge.energy_known;
  hole.primer = options.primer;
  const auto own = options.delays.find(static_cast<long>(index) + 1);
  hole.firing_time =
      own != options.delays.end() ? own->second : static_cast<double>(index) * options.interval;
  hole.shape.hole_radius = charge.hole_radius;
  hole.shape.charge_radius = charge.charge_radius.value_or(charge.hole_radius);
  hole.shape.chamber_length = (zone.collar - zone.toe).norm();
  hole.shape.charge_length = charge.charge_length.value_or(hole.shape.chamber_length);
  if (options.pattern) apply_deck(hole, options, options.pattern->decks()[index]);
  check_shape(hole.shape);
  hole.exponent = exponent_of(options, options.attenuation, hole.explosive);
  hole.decoupling = charge.decoupling;
  if (charge.decoupling.coupling == Coupling::stemming && !charge.coupling_exponent_typed) {
    hole.decoupling.coupling_exponent = hole.exponent;  // stemming is crushed rock
  }
  if (!options.needs_borehole_pressure()) return hole;
  hole.initial_pressure = initial_pressure(charge, hole.explosive);
  hole.wall_pressure =
      wall_pressure(hole.initial_pressure, product_expansion(charge, hole.explosive), hole.shape,
                    hole.decoupling);
  return hole;
}

double wall_peak(const BlastOptions& options, const LoadedHole& hole, const Hole& zone) {
  if (!options.pulse) return 0.0;
  if (options.peak_pressure) return *options.peak_pressure;
  return attenuated_pressure(hole.wall_pressure, hole.shape.hole_radius, zone.radius,
                             hole.exponent);
}

BlastLoad blast_load(const BlastOptions& options, const LoadedHole& hole, const Hole& zone) {
  BlastLoad::Parameters parameters{.wave_peak = wall_peak(options, hole, zone),
                                   .pulse = options.pulse_shape,
                                   .gas = options.gas,
                                   .isentrope = options.charge.isentrope,
                                   .charge_volume = hole.shape.charge_volume(),
                                   .vent_time = options.vent_time,
                                   .vent_decay = options.vent_decay};
  // Without a P0 there is no gas either: any pressure that the law takes will do.
  parameters.isentrope.initial_pressure =
      hole.initial_pressure > 0.0 ? hole.initial_pressure : parameters.isentrope.switch_pressure;
  if (options.charge.jwl) parameters.jwl = hole.explosive.jwl;
  parameters.free_volume_ratio = free_volume_ratio(hole.shape, hole.decoupling);
  if (options.vent_by_flow) {
    parameters.flow = options.flow;
    parameters.flow->hole_radius = hole.shape.hole_radius;
    parameters.flow->zone_radius = zone.radius;
    parameters.flow->products_mass = hole.explosive.density * hole.shape.charge_volume();
  }
  return BlastLoad(parameters);
}

void check_zone(const BlastOptions& options, const Hole& zone, std::size_t index) {
  const double diameter =
      options.pattern ? options.pattern->decks()[index].diameter : 2.0 * options.charge.hole_radius;
  if (2.0 * zone.radius >= diameter) return;
  std::ostringstream text;
  text << "hole_diameter must not exceed that of the crushed zone of hole " << index + 1 << ", "
       << 2.0 * zone.radius << " [m], got '" << diameter << "'";
  refuse(options.where, text.str());
}

/// The pattern must be the one that the rock was cut for.
void check_pattern(const BlastOptions& options, const std::vector<Hole>& zones) {
  const std::vector<Deck>& decks = options.pattern->decks();
  if (decks.size() != zones.size()) {
    refuse(options.where, "hole_table must have one row for each of the " +
                              std::to_string(zones.size()) + " holes of create_blocks, got " +
                              std::to_string(decks.size()) + " rows");
  }
  constexpr double kSamePlace = 1e-6;  // [m]
  for (std::size_t k = 0; k < zones.size(); ++k) {
    if ((decks[k].toe - zones[k].toe).norm() < kSamePlace &&
        (decks[k].collar - zones[k].collar).norm() < kSamePlace) {
      continue;
    }
    refuse(options.where, "row " + std::to_string(k + 1) + " of hole_table (hole '" +
                              decks[k].hole + "') is not where create_blocks has its hole " +
                              std::to_string(k + 1));
  }
}

HoleBlast hole_blast(const BlastOptions& options, const Hole& zone, std::size_t index) {
  try {
    const LoadedHole hole = loaded_hole(options, zone, index);
    const Vec3 axis = (zone.collar - zone.toe).normalized();
    return {blast_load(options, hole, zone),
            DetonationFront({.toe = zone.toe,
                             .collar = zone.toe + hole.shape.charge_length * axis,
                             .detonation_velocity = hole.explosive.detonation_velocity,
                             .firing_time = hole.firing_time,
                             .primer = hole.primer})};
  } catch (const InputError& error) {
    refuse(options.where, "hole " + std::to_string(index + 1) + ": " + error.what());
  }
}

void describe_pressures(std::ostream& text, const BlastOptions& options, const LoadedHole& hole) {
  text << "  explosive " << hole.explosive.name << ": " << hole.explosive.density << " kg/m3, "
       << hole.explosive.detonation_velocity << " m/s";
  if (hole.energy_known) text << ", " << hole.explosive.energy / 1e6 << " MJ/kg";
  if (!hole.explosive.source.empty()) text << " (" << hole.explosive.source << ")";
  text << '\n';
  if (!options.needs_borehole_pressure()) return;
  text << "  borehole pressure P0 = " << hole.initial_pressure / kMPa
       << " MPa; by formula: " << alternative_pressures(options.charge, hole.explosive) << '\n';
  if (hole.wall_pressure != hole.initial_pressure) {
    text << "  decoupled: " << hole.wall_pressure / kMPa << " MPa on the wall, products free in "
         << free_volume_ratio(hole.shape, hole.decoupling) << " V0\n";
  }
}

/// P1 by every exponent that is known, so that the choice can be judged.
void describe_wave(std::ostream& text, const BlastOptions& options, const LoadedHole& hole,
                   const Hole& zone) {
  text << "  wave peak P1 = " << wall_peak(options, hole, zone) / kMPa
       << " MPa on r1 = " << zone.radius << " m (" << zone.radius / hole.shape.hole_radius
       << " hole radii, exponent " << hole.exponent << "), rise " << options.pulse_shape.rise_time
       << " s";
  if (hole.wall_pressure > 0.0) {
    const auto other = [&](const char* name, double exponent) {
      if (exponent <= 0.0) return;
      text << ", " << name << " (" << exponent << ") "
           << attenuated_pressure(hole.wall_pressure, hole.shape.hole_radius, zone.radius,
                                  exponent) /
                  kMPa;
    };
    text << "; by exponent";
    other("shock", exponent_of(options, Attenuation::shock, hole.explosive));
    other("Liu-Katsabanis", exponent_of(options, Attenuation::liu_katsabanis, hole.explosive));
    other("Hino", kHinoExponent);
    text << " MPa";
  }
  text << '\n';
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

std::vector<HoleBlast> hole_blasts(const BlastOptions& options,
                                   const std::vector<Hole>& crushed_zones) {
  const int count = static_cast<int>(crushed_zones.size());
  if (count == 0) refuse(options.where, "there is no hole to load; give create_blocks a hole");
  for (const auto& [number, delay] : options.delays) {
    if (number >= 1 && number <= count) continue;
    refuse(options.where, "hole must be from 1 to " + std::to_string(count) +
                              ", the holes of create_blocks, got '" + std::to_string(number) + "'");
  }
  if (options.pattern) check_pattern(options, crushed_zones);
  std::vector<HoleBlast> blasts;
  for (int i = 0; i < count; ++i) {
    const auto index = static_cast<std::size_t>(i);
    check_zone(options, crushed_zones[index], index);
    blasts.push_back(hole_blast(options, crushed_zones[index], index));
  }
  return blasts;
}

std::vector<ChargeEnergy> charge_energies(const BlastOptions& options,
                                          const std::vector<Hole>& crushed_zones) {
  std::vector<ChargeEnergy> energies;
  for (std::size_t k = 0; k < crushed_zones.size(); ++k) {
    const LoadedHole hole = loaded_hole(options, crushed_zones[k], k);
    const double mass = hole.explosive.density * hole.shape.charge_volume();
    energies.push_back({mass, hole.energy_known ? mass * hole.explosive.energy : 0.0});
  }
  return energies;
}

std::string describe(const BlastOptions& options, const std::vector<Hole>& crushed_zones,
                     const std::vector<HoleBlast>& blasts) {
  const Hole& zone = crushed_zones.front();
  const BlastLoad& load = blasts.front().load();
  const LoadedHole hole = loaded_hole(options, zone, 0);
  std::ostringstream text;
  text.precision(4);
  text << options.where << ": " << blasts.size() << " hole(s), hole 1:\n";
  describe_pressures(text, options, hole);
  describe_wave(text, options, hole, zone);
  if (options.gas) {
    text << "  gas from " << load.gas_pressure(0.0, 0.0) / kMPa
         << " MPa at Vg = " << load.start_volume()
         << " m3, charge volume V0 = " << load.charge_volume() << " m3, ";
    if (options.vent_by_flow) {
      text << "leaves through the collar once " << options.flow.stemming_length
           << " m of stemming are out, and through cracks from " << options.flow.crack_delay
           << " s on\n";
    } else {
      text << "vents after " << options.vent_time << " s, decay " << options.vent_decay << " s\n";
    }
  }
  text << "  firing times [s]:";
  for (const HoleBlast& blast : blasts) text << ' ' << blast.firing_time();
  text << '\n';
  return text.str();
}

}  // namespace muckpile
