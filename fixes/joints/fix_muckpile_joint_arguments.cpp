// SPDX-License-Identifier: GPL-2.0-or-later
// fix muckpile/joint: its keywords, and the joint materials that they make.
// Scope: words to numbers; what the numbers do is core's.
#include "fixes/joints/fix_muckpile_joint_arguments.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "args/input_error.h"
#include "args/suggestion.h"
#include "bond/law/joint_law_table.h"
#include "bond/law/zone_words.h"
#include "fixes/engine/find_view.h"
#include "fixes/engine/style_args.h"
#include "fixes/interfaces/facet_store.h"
#include "fixes/interfaces/keyword_tables.h"

namespace muckpile {
namespace {

constexpr double kDegree = M_PI / 180.0;

/// Of a joint alone [Pa/m]; 0 stands for rigid.
Range stiffness_range() { return Range::closed(0.0, 1e15); }

/// The upper end stands for rock that does not break.
Range strength_range() { return Range::closed(0.0, 1e12); }

/// What may differ from zone to zone: these and add_strength_keywords().
void add_rock_keywords(ArgTable& table) {
  table.real("youngs_modulus", "Pa", Range::closed(1e5, 1e13), std::nullopt, "of the rock")
      .real("poisson_ratio", "", Range::right_open(0.0, 0.5), std::nullopt, "of the rock")
      .real("density", "kg/m3", Range::closed(100.0, 30000.0), std::nullopt,
            "of the rock; sets the damping only")
      .real("cohesion", "Pa", strength_range(), std::nullopt,
            "shear strength without normal stress")
      .real("friction_angle", "deg", Range::right_open(0.0, 90.0), std::nullopt,
            "of the unbroken joint")
      .real("tension", "Pa", strength_range(), std::nullopt, "tensile strength (cut-off)")
      .real("residual_friction_angle", "deg", Range::right_open(0.0, 90.0), 35.0,
            "of the broken joint")
      .real("normal_stiffness", "Pa/m", stiffness_range(), 0.0,
            "of the joint alone, in series with the rock; 0: rigid")
      .real("shear_stiffness", "Pa/m", stiffness_range(), 0.0,
            "of the joint alone, in series with the rock; 0: rigid")
      .real("damping", "", Range::closed(0.0, 10.0), 0.0,
            "of intact joints, share of density x P-wave speed per area")
      .real("contact_damping", "", Range::closed(0.0, 10.0), 0.05,
            "of closed broken facets, share of density x P-wave speed per area")
      .real("wall_strength", "Pa", strength_range(), 0.0,
            "pressure at which the walls of closed broken joints crush, JCS; 0: they do not");
}

void add_strength_keywords(ArgTable& table) {
  table
      .real("fracture_energy_tension", "J/m2", Range::closed(0.0, 1e9), 0.0,
            "taken as tension falls to nothing, linearly with the opening; 0: at once")
      .real("fracture_energy_shear", "J/m2", Range::closed(0.0, 1e9), 0.0,
            "taken as cohesion falls to nothing, linearly with the slip; 0: at once")
      .real("rate_exponent", "", Range::closed(0.0, 1.0), 0.0,
            "tension and cohesion grow with this power of the strain rate; 0: not")
      .real("reference_rate", "1/s", Range::closed(1e-12, 1e6), 1e-6,
            "strain rate up to which tension is that at rest")
      .real("reference_rate_shear", "1/s", Range::closed(0.0, 1e6), 0.0,
            "the same of cohesion; 0: as reference_rate");
}

const ArgTable& zone_table() {
  static const ArgTable args = [] {
    ArgTable table("zone");
    add_rock_keywords(table);
    add_strength_keywords(table);
    return table;
  }();
  return args;
}

const ArgTable& table() {
  static const ArgTable args = [] {
    ArgTable table("fix muckpile/joint");
    add_rock_keywords(table);
    table
        .group("joint_class", 3, 3, true,
               "N law NAME, and behind them keywords of that law: natural joints of the planes "
               "to which create_blocks gives class N; from 1 on")
        .group("zone", 1, 1, true,
               "NAME, and behind it keywords of the rock and their values: those of that zone of "
               "create_blocks, where they differ; last of all words");
    add_strength_keywords(table);
    table
        .real("weakening_speed", "m/s", Range::closed(0.0, 1e3), 0.0,
              "speed of slip above which friction of broken joints falls; 0: it does not")
        .real("weakened_friction_angle", "deg", Range::right_open(0.0, 90.0), 11.3,
              "towards which it then falls")
        .integer("step_check", "steps", Range::closed(0, 1000000), 2500,
                 "between looks whether the joints bear the time step, in a run without fix "
                 "muckpile/timestep; 0: none, for runs that are to become unstable")
        .word("contact_check", {"yes", "no"}, "yes",
              "whether a joint that lets go stops a run without pair_style; no: for blocks that "
              "never meet again");
    return table;
  }();
  return args;
}

/// As create_blocks numbers them, which must have come before. A zone without words is found as the
/// run is set up.
std::vector<ZoneWords> in_order_of_store(LAMMPS_NS::LAMMPS& lmp, const std::string& where,
                                         const std::vector<ZoneWords>& zones) {
  const auto* store = engine::find_view<FacetStore>(lmp);
  const std::vector<std::string> known =
      store == nullptr ? std::vector<std::string>() : store->zones();
  std::vector<ZoneWords> ordered;
  for (const std::string& name : known) {
    const auto found = std::ranges::find(zones, name, &ZoneWords::name);
    if (found == zones.end())
      throw InputError(where + ": create_blocks has a zone '" + name + "', so 'zone " + name +
                       " keyword value ...' must be given");
    ordered.push_back(*found);
  }
  for (const ZoneWords& zone : zones) {
    if (std::ranges::find(known, zone.name) != known.end()) continue;
    throw InputError(where + ": zone must be one of create_blocks before it (" +
                     (known.empty() ? std::string("there are none") : joined(known)) + "), got '" +
                     zone.name + "'" + did_you_mean(zone.name, known));
  }
  return ordered;
}

/// The words of the natural joints are read by their laws, the others by the table above.
struct Words {
  std::vector<JointClass> classes;
  ArgValues others;
  std::vector<std::string> zones;  // names
  std::vector<ArgValues> rocks;    // of the zones
};

Words read_words(LAMMPS_NS::LAMMPS& lmp, const std::string& where, int narg, char** arg) {
  return engine::or_engine_error(lmp, [&] {
    const SplitWords split =
        split_zone_words(zone_table(), table(), where, engine::words_of(narg, arg, 3));
    JointClassWords joints = read_joint_classes(table(), where, split.others);
    Words words{std::move(joints.classes), parse_args(table(), where, joints.others), {}, {}};
    std::string echo = words.others.echo() + joints.echo;
    for (const ZoneWords& zone : in_order_of_store(lmp, where, split.zones)) {
      words.zones.push_back(zone.name);
      words.rocks.push_back(zone_values(zone_table(), where, zone, words.others));
      echo += words.rocks.back().echo();
    }
    engine::print_once(lmp, echo);
    return words;
  });
}

JointParameters rock_parameters(const ArgValues& args) {
  JointParameters p;
  p.youngs_modulus = args.real("youngs_modulus");
  p.poisson_ratio = args.real("poisson_ratio");
  p.density = args.real("density");
  p.cohesion = args.real("cohesion");
  p.tension = args.real("tension");
  p.friction_angle = args.real("friction_angle") * kDegree;
  p.residual_friction_angle = args.real("residual_friction_angle") * kDegree;
  p.normal_stiffness = rigid_if_0(args.real("normal_stiffness"));
  p.shear_stiffness = rigid_if_0(args.real("shear_stiffness"));
  p.fracture_energy_tension = args.real("fracture_energy_tension");
  p.fracture_energy_shear = args.real("fracture_energy_shear");
  p.rate_exponent = args.real("rate_exponent");
  p.reference_rate = args.real("reference_rate");
  const double in_shear = args.real("reference_rate_shear");
  p.reference_rate_shear = in_shear > 0.0 ? in_shear : p.reference_rate;
  p.damping = args.real("damping");
  p.contact_damping = args.real("contact_damping");
  const double walls = args.real("wall_strength");
  p.wall_strength = walls > 0.0 ? walls : std::numeric_limits<double>::infinity();
  return p;
}

}  // namespace

const ArgTable& joint_keywords() { return table(); }

JointArguments joint_arguments(LAMMPS_NS::LAMMPS& lmp, const std::string& where, int narg,
                               char** arg) {
  const Words words = read_words(lmp, where, narg, arg);
  const ArgValues& args = words.others;
  JointParameters p = rock_parameters(args);
  p.weakening_speed = args.real("weakening_speed");
  p.weakened_friction_angle = args.real("weakened_friction_angle") * kDegree;
  return engine::or_engine_error(lmp, where, [&] {
    std::vector<JointMaterial> zones;
    for (const ArgValues& rock : words.rocks) {
      JointParameters of_zone = rock_parameters(rock);
      of_zone.weakening_speed = p.weakening_speed;
      of_zone.weakened_friction_angle = p.weakened_friction_angle;
      zones.emplace_back(of_zone);
    }
    return JointArguments{FacetNetwork(JointMaterial(p), words.classes, zones), words.zones,
                          static_cast<int>(args.integer("step_check")),
                          args.word("contact_check") == "yes"};
  });
}

}  // namespace muckpile
