// SPDX-License-Identifier: GPL-2.0-or-later
// The phases of a blast.
// Scope: see the header; what each phase is for: docs/styles/run_blast.md.
#include "run/blast_run.h"

#include <algorithm>
#include <cmath>

#include "args/input_error.h"
#include "args/rounded_text.h"
#include "run/run_laps.h"

namespace muckpile {
namespace {

constexpr double kRounding = 1.000001;  // of a stiffness that was multiplied up from factors
constexpr double kStretch = 0.05;       // of wave_end, from one check of the gas to the next

/// Gas stays in joints whose shear modulus is 100 times its pressure (fix muckpile/gas); a tenth
/// more is for what the pressure may still rise.
constexpr double kBearing = 110.0;
/// Steps within which one that may be longer becomes so.
constexpr long kStepLag = 10;
constexpr double kAnyStep = 1e30;   // s
constexpr double kSnapshots = 0.1;  // of wave_end, at most, from one to the next
/// A step that grows by less is not worth the change.
constexpr double kPays = 0.5;

}  // namespace

BlastRun::BlastRun(const BlastPlan& plan, RunEngine& engine, BlastedRock& rock,
                   const std::string& where)
    : plan_(plan), engine_(engine), rock_(rock) {
  const double left = rock_.stiffness();
  in_throw_ = left < 1.0 && left < kRounding * plan_.softening;
  if (in_throw_ && plan_.ends_with_wave) {
    throw InputError(where +
                     ": end must be rest, as the joints have been softened for the throw already, "
                     "got 'wave'");
  }
  if (plan_.softening > kRounding * left) {
    throw InputError(where + ": softening must be <= " + rounded_text(left) +
                     ", to which the joints have been softened already, got " +
                     rounded_text(plan_.softening) + "; joints cannot become stiffer again");
  }
}

BlastRun::Phase BlastRun::go() {
  prepare();
  Phase phase = in_throw_ ? Phase::settling : Phase::wave;
  const auto over = [&] {
    return phase == Phase::rest || phase == Phase::wave_over || phase == Phase::interrupted;
  };
  while (!over()) phase = step_through(phase);
  if (phase == Phase::rest) tell_of_rest(engine_, plan_.still_share);
  return phase;
}

void BlastRun::prepare() {
  engine_.prepare({in_throw_ ? plan_.throw_name : kFirstName, plan_.wave_end, 200},
                  {.share = plan_.wave_share,
                   .collision = plan_.collision.step,
                   .collision_speed = plan_.collision.speed(),
                   .contact_every = plan_.contact_every});
  // What blocks rest is in the restart file, for a fix that is there before the first run.
  if (in_throw_ && plan_.sleep) rock_.let_blocks_rest();
}

BlastRun::Phase BlastRun::step_through(Phase phase) {
  switch (phase) {
    case Phase::wave:
      return wave();
    case Phase::push:
      return push();
    case Phase::gas_in_joints:
      return wait_for_joints();
    case Phase::gas_in_holes:
      return wait_for_holes();
    case Phase::settling:
      return settle();
    case Phase::rest:
    case Phase::wave_over:
    case Phase::interrupted:
      break;
  }
  return phase;
}

/// Stiff joints carry the waves.
BlastRun::Phase BlastRun::wave() {
  const double from =
      plan_.last_firing + plan_.push_from * (plan_.wave_end - plan_.last_firing);  // [s]
  if (rock_.stiffness() == 1.0) bound_wave_step(stretch_before(from));
  engine_.set_up();
  engine_.take_snapshots_every(steps_of(kSnapshots * plan_.wave_end));
  return go_on_until(from) ? Phase::push : Phase::interrupted;
}

/// With stiff joints, in steps that resolve the pulses on the way.
bool BlastRun::go_on_until(double end) {
  while (steps_until(end) > 0)
    if (!go_on(stretch_before(end))) return false;
  return true;
}

/// From now to the next time at which a pulse begins or has gone.
BlastRun::Stretch BlastRun::stretch_before(double end) const {
  const auto pulse = std::ranges::find_if(
      plan_.pulses, [this](const PulseSpan& span) { return steps_until(span.end) > 0; });
  const bool at_wave_end = end >= plan_.wave_end;
  if (pulse == plan_.pulses.end()) return {plan_.between_step, end, at_wave_end};
  if (steps_until(pulse->begin) > 0)
    return {plan_.between_step, std::min(end, pulse->begin), pulse->begin <= end || at_wave_end};
  return {plan_.pulse_step, std::min(end, pulse->end), at_wave_end};
}

bool BlastRun::pulse_is_ahead() const {
  return std::ranges::any_of(plan_.pulses,
                             [this](const PulseSpan& span) { return steps_until(span.end) > 0; });
}

/// The end is counted in steps, so a step that has just been let loose grows before; to an exact
/// end, one that may grow still takes no more steps than the longest would, but for the last.
bool BlastRun::go_on(const Stretch& stretch) {
  const bool grows = stretch.longest_step > longest_step_;
  bound_wave_step(stretch);
  const long left = steps_until(stretch.end);
  if (!grows) {
    const bool may_grow = stretch.exact && stretch.longest_step < kAnyStep;
    const double share = may_grow ? std::min(1.0, engine_.step() / stretch.longest_step) : 1.0;
    const auto safe = static_cast<long>(share * static_cast<double>(left));
    return run_within(stretch, std::max(std::min(left, kStepLag), safe));
  }
  if (!run_within(stretch, std::min(kStepLag, left))) return false;
  engine_.take_snapshots_every(steps_of(kSnapshots * plan_.wave_end));
  return true;
}

/// Steps that grow on the way do not pass an exact end.
bool BlastRun::run_within(const Stretch& stretch, long steps) {
  const double longest = (stretch.end - engine_.time()) / static_cast<double>(steps);  // [s]
  const bool near = stretch.exact && longest < stretch.longest_step;
  if (near) engine_.cap_step(std::max(longest, engine_.step()));
  const bool goes_on = run(steps);
  if (near) engine_.cap_step(kAnyStep);
  return goes_on;
}

void BlastRun::bound_wave_step(const Stretch& stretch) {
  if (stretch.longest_step == longest_step_) return;
  longest_step_ = stretch.longest_step;
  engine_.bound_step({.share = plan_.wave_share, .longest = longest_step_});
}

/// What is left until wave_end, on softer joints and with a longer step once the waves have gone;
/// softer joints would not bear a pulse.
BlastRun::Phase BlastRun::push() {
  const double look = kStretch * (plan_.wave_end - plan_.last_firing);  // [s]
  for (;;) {
    if (!pulse_is_ahead() && waves_have_gone()) soften_for_push();
    if (steps_until(plan_.wave_end) <= 0) return after_push();
    const bool goes_on = rock_.stiffness() == 1.0
                             ? go_on_until(std::min(engine_.time() + look, plan_.wave_end))
                             : run_for(std::min(look, plan_.wave_end - engine_.time()));
    if (!goes_on) return Phase::interrupted;
  }
}

/// What softening gives up, the elastic energy, is a small share of the kinetic energy then; or it
/// has settled: it does not fall any more, so it is not that of waves but of stresses that are
/// locked in the rock.
bool BlastRun::waves_have_gone() {
  constexpr double kSteady = 0.95, kLocked = 0.1;
  if (rock_.stiffness() != 1.0) return false;
  const double elastic = rock_.elastic_energy(), kinetic = rock_.kinetic_energy();
  const bool settled = elastic > kSteady * elastic_before_ && elastic < kLocked * kinetic;
  const bool first = elastic_before_ == 0.0;
  elastic_before_ = elastic;
  return elastic < plan_.push_elastic * kinetic || (settled && !first);
}

void BlastRun::soften_for_push() {
  const double gas = std::max(rock_.wall_pressure(), rock_.joint_pressure());  // [Pa]
  const double softer = std::max(plan_.push_softening, kBearing * gas / plan_.shear_modulus);
  if (!(softer < kPays && softer > plan_.softening)) return;
  rock_.soften(softer, {});
  engine_.bound_step({.share = plan_.wave_share, .longest = kAnyStep});
  engine_.set_up();
}

BlastRun::Phase BlastRun::after_push() {
  if (plan_.ends_with_wave) {
    engine_.take_snapshots_every(kNoSnapshots);  // another command may go on
    engine_.say("Wave and gas push end after " + rounded_text(engine_.time()) + " s.");
    return Phase::wave_over;
  }
  switch (plan_.gas) {
    case Gas::in_joints:
      return Phase::gas_in_joints;
    case Gas::in_holes:
      return Phase::gas_in_holes;
    case Gas::vents_by_time:
      break;
  }
  return after_gas();
}

BlastRun::Phase BlastRun::after_gas() const {
  return steps_until(plan_.time_end) > 0 ? Phase::settling : Phase::rest;
}

/// Softened joints do not bear the pressure of gas: the throw begins once it has all but done its
/// work, and what is left is released then.
BlastRun::Phase BlastRun::wait_for_joints() {
  for (;;) {
    if (steps_until(plan_.time_end) <= 0) return Phase::rest;
    const double before = rock_.blast_work();  // [J]
    if (!run_for(kStretch * plan_.wave_end)) return Phase::interrupted;
    const double work = rock_.blast_work();
    const double added = work != 0.0 ? std::abs((work - before) / work) : 0.0;
    if (added >= plan_.gas_rest && engine_.time() <= plan_.gas_patience * plan_.wave_end) continue;
    tell_of_joints(added);
    return after_gas();
  }
}

void BlastRun::tell_of_joints(double work_share) {
  if (work_share > plan_.gas_rest)
    engine_.warn("the gas still works; it is released now. A larger gas_patience waits longer.");
  engine_.say("The first phase ends after " + rounded_text(engine_.time()) +
              " s: the last twentieth of wave_end added " + rounded_text(work_share) +
              " of its work, and " + rounded_text(rock_.joint_pressure()) +
              " Pa at most are left in a joint.");
}

BlastRun::Phase BlastRun::wait_for_holes() {
  while (rock_.wall_pressure() >= plan_.hole_rest &&
         engine_.time() <= plan_.gas_patience * plan_.wave_end) {
    if (steps_until(plan_.time_end) <= 0) return Phase::rest;
    if (!run_for(kStretch * plan_.wave_end)) return Phase::interrupted;
  }
  tell_of_holes();
  return after_gas();
}

void BlastRun::tell_of_holes() {
  const double pressure = rock_.wall_pressure();
  engine_.say("The first phase ends after " + rounded_text(engine_.time()) + " s with " +
              rounded_text(pressure) + " Pa at most on a wall.");
  if (pressure > plan_.hole_rest) {
    engine_.warn("that is above hole_rest, " + rounded_text(plan_.hole_rest) +
                 " Pa; softened joints give way to it. A larger gas_patience waits longer.");
  }
}

/// Flight, landing and settling, on soft joints: laps to time_end, or until the rock rests.
BlastRun::Phase BlastRun::settle() {
  begin_settling();
  return run_laps(engine_, plan_.time_end, true) == LapsEnd::interrupted ? Phase::interrupted
                                                                         : Phase::rest;
}

/// From here on closed joints rebound as sphere contacts do, by their restitution, and contacts act
/// at each step: with kicks far apart blocks that rest on each other do not keep their energy.
void BlastRun::begin_settling() {
  if (!in_throw_) rock_.soften(plan_.softening / rock_.stiffness(), plan_.closed_damping);
  engine_.begin_phase({plan_.throw_name, plan_.time_end, 1000});
  engine_.bound_step({.share = plan_.stable_share,
                      .longest = kAnyStep,
                      .collision = plan_.collision.step,
                      .collision_speed = plan_.collision.speed(),
                      .contact_every = 1});
  engine_.set_up();
  if (!in_throw_ && plan_.sleep) rock_.let_blocks_rest();
  engine_.take_snapshots_every(kNoSnapshots);
}

bool BlastRun::run(long steps) {
  engine_.run(steps, false);
  return !engine_.interrupted();
}

bool BlastRun::run_for(double duration) {
  run_towards(engine_, plan_.time_end, duration);
  return !engine_.interrupted();
}

long BlastRun::steps_until(double time) const { return muckpile::steps_until(engine_, time); }

long BlastRun::steps_of(double duration) const { return muckpile::steps_of(engine_, duration); }

}  // namespace muckpile
