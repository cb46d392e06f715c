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
#include "run/phase_name.h"

namespace muckpile {
namespace {

void add_phases(ArgTable& table) {
  table
      .word("wave_end", {}, "auto",
            "earliest end of wave and gas push [s], > 0 and <= 1000; auto: by fix muckpile/blast")
      .word("end", {"rest", "wave"}, "rest",
            "rest: the run ends when the rock rests; wave: at wave_end, before the throw")
      .word("throw_name", {}, "throw",
            "of the last phase, for screen and history.csv; without commas and quotes");
}

void add_steps(ArgTable& table) {
  table
      .real("wave_share", "", Range::closed(0.01, 1.0), 0.9,
            "longest step, as a share of the longest stable one, until the gas has gone")
      .real("crossing_share", "", Range::closed(0.0, 1.0), 0.2,
            "longest step in a pulse over the time of a wave across block_min, between a fifth "
            "and two fifths of the pulse's rise; 0: that fifth")
      .integer("contact_every", "steps", Range::closed(1, 64), 16,
               "most steps from one act of the contacts to the next; 1: they act at each")
      .integer("sleep", "", Range::closed(0, 1), 1,
               "1: blocks at rest among blocks at rest are left alone in the throw; 0: none")
      .real("sleep_distance", "m", Range::closed(1e-6, 0.1), 5e-3,
            "distance of fix muckpile/sleep");
}

void add_softening(ArgTable& table) {
  table
      .real("softening", "", Range::right_open(1e-7, 1.0), 2e-4,
            "joint stiffness in the throw over that at the start")
      .real("push_softening", "", Range::closed(1e-3, 1.0), 0.1,
            "joint stiffness while the gas pushes over that at the start; 1: unchanged")
      .real("push_elastic", "", Range::closed(0.0, 0.1), 0.01,
            "share of the kinetic energy: with less elastic energy than that the waves have gone")
      .real("push_from", "", Range::closed(0.1, 1.0), 0.35,
            "share of the time from the last firing to wave_end at which the push begins")
      .real(
          "hole_rest", "Pa", Range::closed(1e3, 1e9), 3e5,
          "greatest pressure on a wall with which the throw begins, where gas leaves by flow alone")
      .real("gas_rest", "", Range::left_open(0.0, 0.1), 5e-4,
            "share of the blast's work: the throw begins when a twentieth of wave_end adds less, "
            "where gas enters joints")
      .real("gas_patience", "", Range::closed(1.0, 1000.0), 4.0,
            "times wave_end, after which gas that is left is released");
}

double wave_end_of(const ArgValues& words, const BlastTiming& timing, const std::string& where) {
  const std::string& text = words.word("wave_end");
  if (text != "auto")
    return parse_real(where, "wave_end", text, "s", Range::left_open(0.0, 1000.0));
  if (!timing.vent_time || !timing.vent_decay) {
    throw InputError(where +
                     ": wave_end must be a time [s] where the gas leaves by flow and fix "
                     "muckpile/blast has no vent_time and vent_decay, got 'auto'; about 1.1e-2 s "
                     "per metre of burden after the last firing");
  }
  const double gas = *timing.vent_time + 5.0 * *timing.vent_decay;  // [s]
  return std::max(timing.last_firing + gas, timing.pulse_end);
}

/// A fifth of the pulse's rise; or, where blocks are too coarse for that, of the time of a wave
/// across the smallest, within which one gives way to a load. There only the pulse's impulse must
/// be right: its error is 0.08 (step/rise)^2 at most, 1.3 %. And a wall, at P/(rho c_P), is to move
/// by no more than a hundredth of its radius. Measured in docs/theory/timestep.md.
double pulse_step(const ArgValues& words, const BlastScene& scene) {
  constexpr double kOfRise = 0.2, kOfRiseForImpulse = 0.4, kWallMoves = 0.01;
  const double rise = scene.timing.rise_time;  // [s]
  if (!(rise > 0.0)) return scene.gas_step;
  const double crossing = words.real("block_min") / scene.rock.fastest_wave;       // [s]
  const double wall = kWallMoves * scene.rock.impedance / scene.timing.wall_load;  // [s]
  const double coarse =
      std::min({words.real("crossing_share") * crossing, wall, kOfRiseForImpulse * rise});
  return std::min(std::max(kOfRise * rise, coarse), scene.gas_step);
}

/// What the flow of the gas bears (docs/theory/timestep.md); without it no rock has been tried with
/// more than three fifths of the pulse's rise.
double between_step(const BlastScene& scene) {
  constexpr double kOfRise = 0.6;
  const double rise = scene.timing.rise_time;  // [s]
  return rise > 0.0 ? std::min(kOfRise * rise, scene.gas_step) : scene.gas_step;
}

/// In the order of time, each from ten of the pulse's steps before the charge fires. Those with so
/// short a gap between them that two changes of the step are not worth it are one.
std::vector<PulseSpan> joined(std::vector<PulseSpan> spans, const BlastPlan& plan) {
  constexpr double kSteps = 10.0, kGap = 40.0;
  const double gap = kGap * plan.pulse_step + kSteps * plan.between_step;  // [s]
  std::ranges::sort(spans, {}, &PulseSpan::begin);
  std::vector<PulseSpan> apart;
  for (const PulseSpan& span : spans) {
    const double begin = span.begin - kSteps * plan.pulse_step;
    if (!apart.empty() && begin <= apart.back().end + gap)
      apart.back().end = std::max(apart.back().end, span.end);
    else
      apart.push_back({begin, span.end});
  }
  return apart;
}

void check(const BlastPlan& plan, const BlastTiming& timing, const std::string& where) {
  const auto refuse = [&where](const std::string& why) { throw InputError(where + ": " + why); };
  if (std::abs(timing.start) > 1e-9 * plan.time_end)
    refuse("the charges must fire in the first run of all: they have not been in a run yet, and " +
           rounded_text(timing.start) + " s are over");
  if (plan.wave_end < (1.0 - 1e-9) * timing.pulse_end) {
    refuse("wave_end must be >= " + rounded_text(timing.pulse_end) +
           " s, when the pulse of the last charge has gone, got " + rounded_text(plan.wave_end) +
           " s; rise_time of fix muckpile/blast decides how long it lasts");
  }
  if (plan.time_end <= plan.wave_end) {
    refuse("time_end must be > wave_end, " + rounded_text(plan.wave_end) + " s, got " +
           rounded_text(plan.time_end) + " s");
  }
}

}  // namespace

ArgTable run_blast_table() {
  ArgTable table("run_blast");
  add_end_words(table);
  add_phases(table);
  add_collision_words(table);
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
  plan.ends_with_wave = words.word("end") == "wave";
  plan.throw_name = phase_name(where, "throw_name", words.word("throw_name"));
  plan.last_firing = scene.timing.last_firing;
  plan.wave_end = wave_end_of(words, scene.timing, where);
  plan.time_end = words.real("time_end");
  plan.still_share = words.real("still_share");
  plan.pulse_step = pulse_step(words, scene);
  plan.between_step = between_step(scene);
  if (scene.timing.rise_time > 0.0) plan.pulses = joined(scene.timing.pulses, plan);
  plan.wave_share = words.real("wave_share");
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
  plan.collision = collision_step(words, rock.density, scene.contacts);
  plan.contact_every = words.integer("contact_every");
  plan.closed_damping = closed_damping(scene.contacts.restitution);
  check(plan, scene.timing, where);
  return plan;
}

}  // namespace muckpile
