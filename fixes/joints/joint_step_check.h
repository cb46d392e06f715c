// SPDX-License-Identifier: GPL-2.0-or-later
// Looks whether the joints bear the time step, in runs where no fix muckpile/timestep does.
// Scope: a part of fix muckpile/joint; the bound is core's (bond/linear/stable_step.h).
#pragma once

#include <fix.h>

#include <limits>
#include <string>

#include "fixes/interfaces/step_limit.h"

namespace muckpile {

class JointStepCheck {
 public:
  /// `every`: steps between two looks, 0: none. `where` begins every message.
  JointStepCheck(int every, std::string where) : every_(every), where_(std::move(where)) {}

  /// With forces up to date. Refuses a step above the bound; `run 0`, which takes none, warns.
  /// Collective.
  void at_setup(LAMMPS_NS::LAMMPS& lmp, const StepLimit& joints, double joints_created);
  /// Stops the run once the step is above the bound. Collective.
  void at_end_of_step(LAMMPS_NS::LAMMPS& lmp, const StepLimit& joints);

 private:
  void look(LAMMPS_NS::LAMMPS& lmp, const StepLimit& joints);
  [[nodiscard]] bool is_due(const LAMMPS_NS::LAMMPS& lmp) const;
  [[nodiscard]] bool above_bound(const LAMMPS_NS::LAMMPS& lmp) const;
  [[nodiscard]] std::string fault(const LAMMPS_NS::LAMMPS& lmp, const std::string& when = "") const;

  int every_;
  std::string where_;
  double bound_ = std::numeric_limits<double>::infinity();  // of the last look [s]
  LAMMPS_NS::bigint looked_ = -1;                           // step of the last look
  int known_changes_ = -1;                                  // of the joints' stiffness at it
  double known_joints_ = -1.0;
  bool off_ = true, warned_ = false;
};

}  // namespace muckpile
