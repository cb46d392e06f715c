// SPDX-License-Identifier: GPL-2.0-or-later
// Looks whether the joints bear the time step, in runs where no fix muckpile/timestep does.
// Scope: see the header.
#include "fixes/joints/joint_step_check.h"

#include <comm.h>
#include <error.h>
#include <lammps.h>
#include <modify.h>
#include <update.h>

#include <cmath>
#include <cstdio>

#include "args/numbers.h"
#include "fixes/engine/stop_with_state.h"
#include "fixes/engine/style_args.h"

namespace muckpile {
namespace {

constexpr double kRounding = 1e-6;  // of a bound that a script has written as text
constexpr double kAdvised = 0.9;    // of the bound; leaves room for contacts and for a later look

}  // namespace

void JointStepCheck::at_setup(LAMMPS_NS::LAMMPS& lmp, const StepLimit& joints,
                              double joints_created) {
  off_ = every_ == 0 || lmp.modify->find_fix_style_strict("muckpile/timestep", 0) != nullptr;
  if (off_) return;
  const bool changed =
      joints.stiffness_changes() != known_changes_ || joints_created != known_joints_;
  known_joints_ = joints_created;
  // A look is dear: runs of a few steps in a row share one.
  if (changed || is_due(lmp) || above_bound(lmp)) look(lmp, joints);
  if (!above_bound(lmp)) return;
  if (lmp.update->nsteps > 0) engine::stop(lmp, fault(lmp));
  if (!warned_ && lmp.comm->me == 0) lmp.error->warning(FLERR, fault(lmp).c_str());
  warned_ = true;
}

void JointStepCheck::at_end_of_step(LAMMPS_NS::LAMMPS& lmp, const StepLimit& joints) {
  if (off_) return;
  // A step that has just grown, in a run without set-up, is compared with the bound of this moment.
  if (is_due(lmp) || above_bound(lmp)) look(lmp, joints);
  if (above_bound(lmp)) engine::stop_with_state(lmp, fault(lmp, engine::at_present(lmp)));
}

/// The engine's count of steps may have been set back.
bool JointStepCheck::is_due(const LAMMPS_NS::LAMMPS& lmp) const {
  const LAMMPS_NS::bigint now = lmp.update->ntimestep;
  return looked_ < 0 || now < looked_ || now - looked_ >= every_;
}

void JointStepCheck::look(LAMMPS_NS::LAMMPS& lmp, const StepLimit& joints) {
  looked_ = lmp.update->ntimestep;
  known_changes_ = joints.stiffness_changes();
  const bool guessed = std::isfinite(bound_);
  bound_ = joints.stable_step(Breaking::possible, guessed ? bound_ : 0.0).seconds;
  // The result depends on the guess by some thousandths; a run is refused by that without, which is
  // what fix muckpile/joint tells.
  if (guessed && above_bound(lmp)) bound_ = joints.stable_step(Breaking::possible, 0.0).seconds;
}

bool JointStepCheck::above_bound(const LAMMPS_NS::LAMMPS& lmp) const {
  return lmp.update->dt > (1.0 + kRounding) * bound_;
}

std::string JointStepCheck::fault(const LAMMPS_NS::LAMMPS& lmp, const std::string& when) const {
  char bound[32] = "", advised[32] = "";
  std::snprintf(bound, sizeof bound, "%.4g", bound_);
  std::snprintf(advised, sizeof advised, "%.2g", kAdvised * bound_);
  return where_ + ": the time step must be <= " + bound +
         " s, the longest that the joints bear, got '" + number_text(lmp.update->dt) + "'" + when +
         "; give 'timestep " + advised + "', or fix muckpile/timestep, which keeps to the bound";
}

}  // namespace muckpile
