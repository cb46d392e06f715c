// SPDX-License-Identifier: GPL-2.0-or-later
// Takes a blast through its phases: wave; gas push on softer joints; waiting for the gas; throw and
// settling; rest.
// Scope: decides when a phase ends and what changes there. Phases are told apart by the state that
// the engine is in, so that a run goes on in any of them after a restart file.
#pragma once

#include <string>

#include "run/blast_plan.h"
#include "run/blasted_rock.h"
#include "run/run_engine.h"

namespace muckpile {

class BlastRun {
 public:
  enum class Phase {
    wave,
    push,
    gas_in_joints,
    gas_in_holes,
    settling,
    rest,
    wave_over,
    interrupted
  };

  /// InputError, which begins with `where`: the joints are softer already than the plan has them.
  BlastRun(const BlastPlan& plan, RunEngine& engine, BlastedRock& rock, const std::string& where);

  /// All phases, from the one that the engine is in. What it returns is rest, wave_over or
  /// interrupted.
  Phase go();

  static constexpr const char* kFirstName = "wave_and_gas";

 private:
  void prepare();
  /// A stretch of the wave: the longest step that the pulses allow, until when [s], and whether a
  /// step that grows on the way must not take it farther.
  struct Stretch {
    double longest_step, end;
    bool exact;
  };
  // Each takes steps until its end, and returns what follows.
  Phase step_through(Phase phase);
  Phase wave();
  Phase push();
  Phase wait_for_joints();
  Phase wait_for_holes();
  Phase settle();

  void begin_settling();
  [[nodiscard]] Phase after_push();
  [[nodiscard]] Phase after_gas() const;
  [[nodiscard]] Stretch stretch_before(double end) const;
  [[nodiscard]] bool pulse_is_ahead() const;
  bool go_on_until(double end);
  bool go_on(const Stretch& stretch);
  bool run_within(const Stretch& stretch, long steps);
  void bound_wave_step(const Stretch& stretch);
  [[nodiscard]] bool waves_have_gone();
  void soften_for_push();
  void tell_of_joints(double work_share);
  void tell_of_holes();

  /// False: the engine has been asked to end.
  bool run(long steps);
  bool run_for(double duration);  ///< [s], and not beyond time_end
  [[nodiscard]] long steps_until(double time) const;
  [[nodiscard]] long steps_of(double duration) const;

  BlastPlan plan_;
  RunEngine& engine_;
  BlastedRock& rock_;
  double longest_step_ = 0.0;    // as the engine was told in the wave [s]
  double elastic_before_ = 0.0;  // at the last look whether waves have gone [J]
  bool in_throw_;                ///< from the start: a restart file of a throw
};

}  // namespace muckpile
