// SPDX-License-Identifier: GPL-2.0-or-later
// Words of run_blast to the numbers of its phases.
// Scope: see the header.
#include "run/blast_plan.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "args/input_error.h"
#include "args/numbers.h"
#include "args/rounded_text.h"
#include "contact/collision_time.h"

namespace muckpile {
namespace {

/// Times its rise until a pulse has gone [-]; a starfield pulse has then fallen to 0.4 %. Softened
/// joints do not bear it.
constexpr double kPulse = 10.0;

void add_ends(ArgTable& table) {
  table
      .word("directory", {}, {},
            "where snapshots, history.csv, run.json and restart files go, unless fixes of the "
            "script say otherwise")
      .real("time_end", "s", Range::left_open(0.0, 1000.0), 12.0, "the run ends then at the latest")
      .word("wave_end", {}, "auto",
            "end of wave and gas push [s], at the earliest, > 0 and <= 1000; auto: last firing + "
            "vent_time + 5 vent_decay of fix muckpile/blast")
      .real("still_share", "", Range::right_open(1e-6, 1.0), 0.01,
            "mass share that may still move when the run ends")
      .word("throw_name", {}, "throw", "of the last phase, for screen and history.csv")
      .word("scene", {}, "all", "region, as in fix muckpile/progress")
      .word("solid", {}, "none", "region, as in fix muckpile/progress")
      .integer("restart_every", "steps", Range::closed(0, 2147483647), 0,
               "between restart files, a.restart and b.restart in turn; 0: none");
}

void add_steps(ArgTable& table) {
  table.real("block_min", "m", Range::closed(1e-3, 100.0), {}, "of create_blocks, for collisions")
      .integer("spheres_per_block", "", Range::closed(1, 64), 8, "of create_blocks, for collisions")
      .real("wave_share", "", Range::closed(0.01, 1.0), 0.9,
            "step until the gas has gone over the longest that joints and contacts bear")
      .real("stable_share", "", Range::closed(0.01, 1.0), 0.8,
            "the same in the throw; what is left is for contacts that become stiffer between two "
            "checks")
      .real("steps_per_contact", "", Range::closed(5.0, 1000.0), 8.0,
            "collision of two smallest blocks at the speed of the fastest over the longest step of "
            "the throw")
      .integer("sleep", "", Range::closed(0, 1), 1,
               "1: blocks at rest among blocks at rest are left alone in the throw; 0: none")
      .real("sleep_distance", "m", Range::closed(1e-6, 0.1), 5e-3,
            "distance of fix muckpile/sleep");
}

void add_softening(ArgTable& table) {
  table
      .real("softening", "", Range::closed(1e-7, 1.0), 2e-4,
            "joint stiffness in the throw over that at the start")
      .real("push_softening", "", Range::closed(1e-3, 1.0), 0.1,
            "joint stiffness while the gas pushes over that at the start; 1: as stiff")
      .real("push_elastic", "", Range::closed(0.0, 0.1), 0.005,
            "elastic over kinetic energy, below which the waves have gone")
      .real("push_from", "", Range::closed(0.1, 1.0), 0.35,
            "of the time from the last firing to wave_end: the push is not before")
      .real("hole_rest", "Pa", Range::closed(1e3, 1e9), 3e5,
            "greatest pressure on a wall that the throw begins with, where gas vents by flow from "
            "the holes alone")
      .real("gas_rest", "", Range::left_open(0.0, 0.1), 5e-4,
            "of the blast's work, added in a twentieth of wave_end: with less the throw begins, "
            "where gas enters joints")
      .real("gas_patience", "", Range::closed(1.0, 1000.0), 4.0,
            "times wave_end: then what gas is left is let go");
}

double wave_end_of(const ArgValues& words, const BlastTiming& timing, const std::string& where) {
  const std::string& text = words.word("wave_end");
  if (text == "auto") {
    const double gas = timing.vent_time + 5.0 * timing.vent_decay;  // [s]
    return timing.last_firing + std::max(gas, kPulse * timing.rise_time);
  }
  return parse_real(where, "wave_end", text, "s", Range::left_open(0.0, 1000.0));
}

/// Nearly incompressible rock gains energy as it breaks, in proportion to the step (fix
/// muckpile/joint, Restrictions). No rock of Poisson ratio up to 0.4 has a shorter step for it; at
/// 0.45 a fourth keeps the balance within 1 %.
double share_of_squeezable(double share, double poisson_ratio) {
  if (poisson_ratio <= 0.4) return share;
  const double squeezable = (1.0 - 2.0 * poisson_ratio) / 0.2;
  return share * (0.05 + 0.95 * squeezable * squeezable);
}

void plan_throw(const ArgValues& words, const BlastScene& scene, BlastPlan& plan) {
  const BlockContacts& contacts = scene.contacts;
  const long spheres = words.integer("spheres_per_block");
  const SmallBlocks blocks{
      .edge = words.real("block_min"),
      .density = scene.rock.density,
      .spheres = spheres,
      .effective_modulus = contacts.youngs_modulus /
                           (2.0 * (1.0 - contacts.poisson_ratio * contacts.poisson_ratio))};
  plan.collision_step =
      collision_time_of(blocks, BlastPlan::kCollisionSpeed) / words.real("steps_per_contact");
  // With 64 spheres a step 0.7 as long as the crowd's was unstable, one 0.6 as long was not; the
  // crowd's factor leaves 0.43, and the step stays that of kCollisionSpeed.
  plan.follows_collisions = crowd_factor(spheres) <= 1.0;
  plan.closed_damping = closed_damping(contacts.restitution);
}

void check(const BlastPlan& plan, const BlastTiming& timing, const std::string& where) {
  const auto refuse = [&where](const std::string& why) { throw InputError(where + ": " + why); };
  if (std::abs(timing.start) > 1e-9 * plan.time_end)
    refuse("the charges must fire in the first run of all: they have not been in a run yet, and " +
           rounded_text(timing.start) + " s are over");
  const double pulse_end = plan.last_firing + kPulse * timing.rise_time;  // [s]
  if (plan.wave_end < (1.0 - 1e-9) * pulse_end) {
    refuse("wave_end must be >= " + rounded_text(pulse_end) +
           " s, when the pulse of the last charge has gone, got " + rounded_text(plan.wave_end) +
           " s");
  }
  if (plan.time_end <= plan.wave_end) {
    refuse("time_end must be > wave_end, " + rounded_text(plan.wave_end) + " s, got " +
           rounded_text(plan.time_end) + " s");
  }
}

}  // namespace

ArgTable run_blast_table() {
  ArgTable table("run_blast");
  add_ends(table);
  add_steps(table);
  add_softening(table);
  return table;
}

double closed_damping(double restitution) {
  const double log_e = std::log(restitution);
  return -std::numbers::sqrt2 * log_e / std::hypot(std::numbers::pi, log_e);
}

BlastPlan blast_plan(const ArgValues& words, const BlastScene& scene, const std::string& where) {
  const RockConstants& rock = scene.rock;
  BlastPlan plan;
  plan.throw_name = words.word("throw_name");
  plan.last_firing = scene.timing.last_firing;
  plan.wave_end = wave_end_of(words, scene.timing, where);
  plan.time_end = words.real("time_end");
  // In weak rock the joints bear a longer step than the pulse does. Error of the energy balance at
  // 5 GPa: 3.6 % with 3 steps in the rise, 0.7 to 1 % with 5, 0.13 % with 10.
  plan.pulse_step = 0.2 * scene.timing.rise_time;
  plan.wave_share = share_of_squeezable(words.real("wave_share"), rock.poisson_ratio);
  plan.stable_share = words.real("stable_share");
  plan.push_softening = words.real("push_softening");
  plan.push_elastic = words.real("push_elastic");
  plan.push_from = words.real("push_from");
  plan.shear_modulus = rock.youngs_modulus / (2.0 * (1.0 + rock.poisson_ratio));
  plan.gas = scene.gas;
  plan.hole_rest = words.real("hole_rest");
  plan.gas_rest = words.real("gas_rest");
  plan.gas_patience = words.real("gas_patience");
  plan.softening = words.real("softening");
  plan.sleep = words.integer("sleep") == 1;
  plan_throw(words, scene, plan);
  check(plan, scene.timing, where);
  return plan;
}

}  // namespace muckpile
