// SPDX-License-Identifier: GPL-2.0-or-later
// Explosive and crushed zone of an input script; see the header.
#include "explosive/charge_design.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "args/csv_table.h"
#include "args/input_error.h"
#include "explosive/attenuation.h"
#include "explosive/charge_options.h"
#include "explosive/charge_window.h"
#include "explosive/crushed_zone.h"
#include "explosive/deck_charge.h"
#include "explosive/design_zones.h"
#include "geometry/size/size_law.h"

namespace muckpile {
namespace {

constexpr double kMPa = 1e6;

/// Speed of P waves in isotropic elastic rock [m/s].
double p_wave_speed(double youngs_modulus, double poisson_ratio, double density) {
  const double nu = poisson_ratio;
  return std::sqrt(youngs_modulus * (1.0 - nu) / ((1.0 + nu) * (1.0 - 2.0 * nu) * density));
}

/// The chosen model's input; what the script left out stays 0 and is refused by who needs it.
struct Rock {
  double youngs_modulus, poisson_ratio, density, ucs, tensile_strength;
  [[nodiscard]] bool elastic() const { return youngs_modulus > 0.0 && density > 0.0; }
  [[nodiscard]] double speed() const {
    return p_wave_speed(youngs_modulus, poisson_ratio, density);
  }
};

Rock rock_of(const ArgValues& values, const std::string& where) {
  const auto number = [&](const char* name, const char* unit, Range range) {
    return optional_real(values, where, name, unit, range).value_or(0.0);
  };
  return {number("youngs_modulus", "Pa", Range::closed(1e5, 1e13)),
          number("poisson_ratio", "", Range::right_open(0.0, 0.5)),
          number("rock_density", "kg/m3", Range::closed(100.0, 30000.0)),
          number("ucs", "Pa", Range::closed(1e4, 1e11)),
          number("tensile_strength", "Pa", Range::closed(1e3, 1e11))};
}

/// What counts for every hole.
CrushedZoneInput rock_input(const ArgValues& values, const Rock& rock, const std::string& where) {
  CrushedZoneInput in;
  in.youngs_modulus = rock.youngs_modulus;
  in.poisson_ratio = rock.poisson_ratio;
  in.ucs = rock.ucs;
  in.tensile_strength = rock.tensile_strength;
  in.strain_rate = values.real("strain_rate");
  in.multiple = optional_real(values, where, "crushed_ratio", "", Range::closed(1.0, 20.0))
                    .value_or(in.multiple);
  in.crushing_factor =
      optional_real(values, where, "crushing_factor", "", Range::closed(0.1, 100.0))
          .value_or(in.crushing_factor);
  const auto exponent = read_attenuation_exponent(values, where, Range::left_open(0.0, 10.0));
  in.attenuation_exponent = exponent ? *exponent : crushed_zone_exponent(rock.poisson_ratio);
  return in;
}

bool by_pressure(const ArgValues& values) { return values.word("decoupled_zone") == "pressure"; }

ChargeShape shape_of(const ChargeOptions& charge, const ArgValues& values,
                     const std::string& where) {
  ChargeShape shape;
  shape.hole_radius = 0.5 * values.real("hole_diameter");
  shape.charge_radius = charge.charge_radius.value_or(shape.hole_radius);
  // Only their ratio counts.
  const double charge_length = charge.charge_length.value_or(1.0);
  shape.chamber_length =
      optional_real(values, where, "chamber_length", "m", Range::left_open(0.0, 1e3))
          .value_or(charge_length);
  shape.charge_length = charge.charge_length.value_or(shape.chamber_length);
  return shape;
}

CrushedZoneInput zone_input(const ChargeOptions& charge, const ArgValues& values, const Rock& rock,
                            const std::string& where) {
  const Explosive plain{charge.explosive.density, charge.explosive.detonation_velocity};
  CrushedZoneInput in = rock_input(values, rock, where);
  const ChargeShape shape = shape_of(charge, values, where);
  in.hole_radius = 0.5 * values.real("hole_diameter");
  in.borehole_pressure = initial_pressure(charge, charge.explosive);
  in.cj_pressure = chapman_jouguet_pressure(plain);
  in.wall_shock =
      rock.elastic() ? impedance_matched_pressure(plain, rock.density * rock.speed()) : 0.0;
  if (by_pressure(values)) {
    in.pressure_share = pressure_share(charge, charge.explosive, shape, in.attenuation_exponent);
  } else {
    check_shape(shape);
  }
  return in;
}

/// A model that lacks an input has no radius.
std::optional<double> radius_if_known(CrushedZone model, const CrushedZoneInput& in) {
  if (model == CrushedZone::dai && in.wall_shock <= 0.0) return std::nullopt;
  try {
    return crushed_zone_radius(model, in);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

/// One line per model: its radius, and the wave's peak there by each exponent.
void describe_zones(std::ostream& text, const CrushedZoneInput& in, const Rock& rock,
                    const ChargeOptions& charge, CrushedZone chosen) {
  text << "  crushed zone    r1 [m]  r1/hole   P1 [MPa]: exponent " << in.attenuation_exponent
       << "  shock";
  if (rock.elastic()) text << "  Liu-Katsabanis";
  text << "  Hino\n";
  for (std::size_t k = 0; k < kCrushedZones.size(); ++k) {
    const auto model = static_cast<CrushedZone>(k);
    const auto radius = radius_if_known(model, in);
    if (!radius) continue;
    text << "  " << (model == chosen ? "* " : "  ") << kCrushedZones[k] << ": " << *radius << "  "
         << *radius / in.hole_radius << "  ";
    const auto peak = [&](double exponent) {
      text << ' ' << attenuated_pressure(wall_peak(in), in.hole_radius, *radius, exponent) / kMPa;
    };
    peak(in.attenuation_exponent);
    peak(crushed_zone_exponent(in.poisson_ratio));
    if (rock.elastic()) {
      peak(liu_katsabanis_exponent(rock.speed(), charge.explosive.detonation_velocity));
    }
    peak(kHinoExponent);
    text << '\n';
  }
}

/// Harries' crack counting from the wave on the crushed zone: K = P1/(2 G), the hoop strain of the
/// wall of an elastic cylinder under P1.
void add_harries(std::ostream& text, ChargeDesign& design, const CrushedZoneInput& in,
                 double breaking_strain) {
  const double radius = *design.crushed_radius;
  const double shear_modulus = 0.5 * in.youngs_modulus / (1.0 + in.poisson_ratio);
  const double peak =
      attenuated_pressure(wall_peak(in), in.hole_radius, radius, in.attenuation_exponent);
  const HarriesParameters harries{.hole_radius = radius,
                                  .wall_strain = 0.5 * peak / shear_modulus,
                                  .breaking_strain = breaking_strain,
                                  .absorption = 0.0};
  design.harries_strain = harries.wall_strain;
  text << "  Harries: strain " << harries.wall_strain << " on r1, cracks and their spacing [m]:";
  for (const double multiple : {1.0, 2.0, 4.0, 8.0, 16.0}) {
    const double r = multiple * radius;
    text << " at " << r << " m " << harries_cracks(harries, r) << ", "
         << harries_spacing(harries, r) << ';';
  }
  text << " the last ends at " << harries_reach(harries) << " m\n";
}

std::vector<TimedCharge> timed_charges(const HoleTable& pattern, const ChargeOptions& charge) {
  std::vector<TimedCharge> charges;
  for (const Deck& deck : pattern.decks()) {
    const NamedExplosive explosive = deck_explosive(charge, deck);
    const ChargeShape shape = deck_shape(charge, deck, deck.to - deck.from);
    charges.push_back({deck.firing_time, explosive.density * shape.charge_volume()});
  }
  return charges;
}

bool typed(const ArgValues& values, const char* name) { return values.word(name) != "auto"; }

/// As typed; a typed crushed_ratio is of `multiple`, a typed crushing_factor of `strength`.
CrushedZone zone_model(const ArgValues& values, const std::string& where) {
  const bool by_ratio = typed(values, "crushed_ratio");
  auto model = by_ratio ? CrushedZone::multiple : CrushedZone::strength;
  if (typed(values, "crushed_zone")) {
    const auto at =
        std::find(kCrushedZones.begin(), kCrushedZones.end(), values.word("crushed_zone"));
    model = static_cast<CrushedZone>(at - kCrushedZones.begin());
  }
  const std::string got = kCrushedZones[static_cast<std::size_t>(model)];
  if (by_ratio && model != CrushedZone::multiple)
    refuse(where, "crushed_ratio is for crushed_zone multiple, got crushed_zone " + got);
  if (typed(values, "crushing_factor") && model != CrushedZone::strength)
    refuse(where, "crushing_factor is for crushed_zone strength, got crushed_zone " + got);
  return model;
}

std::vector<std::string> zone_words() {
  std::vector<std::string> words{kCrushedZones.begin(), kCrushedZones.end()};
  words.emplace_back("auto");
  return words;
}

void require_ucs(const ArgValues& values, CrushedZone model) {
  if (model != CrushedZone::strength || typed(values, "ucs")) return;
  throw InputError(
      "crushed_zone strength needs ucs [Pa] of the rock; or give crushed_zone multiple");
}

/// The hole of hole_diameter.
void add_hole(std::ostream& text, ChargeDesign& design, const ChargeOptions& charge,
              const ArgValues& values, const std::string& where) {
  const Rock rock = rock_of(values, where);
  const CrushedZone model = zone_model(values, where);
  require_ucs(values, model);
  if (model == CrushedZone::dai && !rock.elastic()) {
    throw InputError("crushed_zone dai needs youngs_modulus [Pa] and rock_density [kg/m3]");
  }
  const CrushedZoneInput in = zone_input(charge, values, rock, where);
  CrushedZoneInput full = in;
  full.pressure_share = 1.0;
  design.full_radius = crushed_zone_radius(model, full);
  design.crushed_radius = crushed_zone_radius(model, in);
  text << "  borehole pressure P0 = " << in.borehole_pressure / kMPa
       << " MPa; by formula: " << alternative_pressures(charge, charge.explosive) << '\n';
  if (in.pressure_share != 1.0) {
    text << "  decoupled: " << wall_peak(in) / kMPa << " MPa on the wall; r1 of a full hole "
         << design.full_radius << " m\n";
  }
  describe_zones(text, in, rock, charge, model);
  if (in.youngs_modulus > 0.0) add_harries(text, design, in, values.real("breaking_strain"));
}

void add_pattern(std::ostream& text, ChargeDesign& design, const ChargeOptions& charge,
                 const ArgValues& values, const std::string& where) {
  const CsvTable table = CsvTable::read(values.word("hole_table"));
  design.pattern = HoleTable(table);
  const std::vector<TimedCharge> charges = timed_charges(*design.pattern, charge);
  for (const TimedCharge& each : charges) design.pattern_mass += each.mass;
  design.window_mass = largest_within(charges, kVibrationWindow);
  const CrushedZone model = zone_model(values, where);
  if (model != CrushedZone::strength && model != CrushedZone::multiple) {
    throw InputError("hole_table needs crushed_zone strength or multiple, got '" +
                     values.word("crushed_zone") + "'");
  }
  const auto needs_radius = [](const Deck& deck) { return !deck.crushed_radius; };
  if (std::ranges::any_of(design.pattern->decks(), needs_radius)) require_ucs(values, model);
  const CrushedZoneInput rock = rock_input(values, rock_of(values, where), where);
  const PatternZones zones =
      pattern_zones(*design.pattern, charge, model, rock, by_pressure(values));
  design.pattern_crushed_radius = zones.smallest;
  design.pattern_full_radius = zones.smallest_full;
  design.crushed_table = with_zones(table, zones);
  text << "  pattern: " << design.pattern->holes() << " holes, " << design.pattern->decks().size()
       << " charged decks, the last fires at " << design.pattern->last_firing_time() << " s; "
       << design.pattern_mass << " kg of explosive, at most " << design.window_mass << " kg within "
       << 1e3 * kVibrationWindow << " ms\n";
  text << "  crushed zones: the smallest of all decks is " << zones.smallest << " m; "
       << zones.narrower << " are narrower than if the charge filled its chamber, "
       << zones.from_table << " have the crushed_radius_m of the table\n";
}

/// Faults of the core name the keyword; the command goes before.
template <class Add>
void named(const std::string& where, const Add& add) {
  try {
    add();
  } catch (const InputError& error) {
    const std::string text = error.what();
    throw InputError(text.rfind(where, 0) == 0 ? text : where + ": " + text);
  }
}

}  // namespace

ArgTable charge_design_table() {
  ArgTable table("charge_design");
  add_explosive_keywords(table);
  add_borehole_keywords(table);
  add_decoupling_keywords(table);
  add_optional(table, "chamber_length",
               "charge and air deck above it [m], > 0 and <= 1000; auto: charge_length, no deck. "
               "With hole_table the table's");
  add_expansion_keywords(table);
  table
      .real("hole_diameter", "m", Range::closed(0.0, 10.0), 0.0,
            "diameter of the hole; 0: no crushed zone is asked for")
      .word("crushed_zone", zone_words(), "auto",
            "formula for the crushed zone's radius; auto: strength, or multiple where "
            "crushed_ratio is given")
      .word("crushed_ratio", {}, "auto",
            "radius over hole radius of a charge that fills its chamber, 1 to 20, for `multiple`; "
            "auto: 3")
      .word("crushing_factor", {}, "auto",
            "peak down to which rock is crushed, over its ucs, 0.1 to 100, for `strength`; auto: "
            "3.15")
      .word("decoupled_zone", {"pressure", "full"}, "pressure",
            "crushed zone of a charge that does not fill its chamber: by its pressure on the wall, "
            "or that of one that does")
      .real("strain_rate", "1/s", Range::closed(1e2, 1e4), 1e3, "in the crushed zone, for `dai`");
  table.real("breaking_strain", "", Range::closed(1e-6, 1.0), 3e-4,
             "dynamic tensile strain at which rock cracks, for Harries' counting (2e-4 to 6e-4)");
  add_attenuation_keywords(table, {"shock"}, "or that of a shock, 2 + nu/(1 - nu)");
  table.word("hole_table", {}, "none", "CSV file of a pattern")
      .word("crushed_table", {}, "none",
            "CSV file to write, which may be that of `hole_table`: the pattern with the crushed "
            "zone of each deck, for create_blocks");
  add_optional(table, "rock_density", "[kg/m3], 100 to 30000; needed by `dai`");
  add_optional(table, "youngs_modulus",
               "of the rock [Pa], 1e5 to 1e13; needed by `esen` and `dai`");
  add_optional(table, "poisson_ratio", "of the rock, >= 0 and < 0.5; auto: 0");
  add_optional(
      table, "ucs",
      "uniaxial compressive strength of the intact rock [Pa], 1e4 to 1e11; needed by `strength`, "
      "`esen`, `kanchibotla` and `dai`");
  add_optional(table, "tensile_strength",
               "of the intact rock [Pa], 1e3 to 1e11; needed by `djordjevic`");
  return table;
}

ChargeDesign charge_design(const ArgValues& values, const std::string& where) {
  ChargeOptions charge;
  read_explosive(charge, values, where);
  read_decoupling(charge, values, where);
  read_expansion(charge, values, where);
  const NamedExplosive& explosive = charge.explosive;
  ChargeDesign design;
  design.density = explosive.density;
  design.detonation_velocity = explosive.detonation_velocity;
  design.energy = charge.energy_known ? explosive.energy : 0.0;
  std::ostringstream text;
  text.precision(4);
  text << where << ": explosive " << explosive.name << ", " << explosive.density << " kg/m3, "
       << explosive.detonation_velocity << " m/s, " << design.energy / 1e6 << " MJ/kg\n";
  if (values.real("hole_diameter") > 0.0) {
    named(where, [&] { add_hole(text, design, charge, values, where); });
  }
  if (values.word("hole_table") != "none") {
    named(where, [&] { add_pattern(text, design, charge, values, where); });
  } else if (values.given("crushed_table")) {
    refuse(where, "crushed_table needs hole_table");
  }
  design.report = text.str();
  return design;
}

}  // namespace muckpile
