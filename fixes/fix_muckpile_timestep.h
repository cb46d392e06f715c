// SPDX-License-Identifier: GPL-2.0-or-later
// fix muckpile/timestep: keeps the time step a given share of the longest stable one.
// Scope: joints and sphere contacts of blocks; walls are softer or equal, and stand back.
#pragma once

#include <fix.h>

#include <array>
#include <string>

#include "bond/stable_step.h"
#include "interfaces/contact_steps.h"
#include "interfaces/step_limit.h"

namespace muckpile {

class FixMuckpileTimestep : public LAMMPS_NS::Fix {
 public:
  FixMuckpileTimestep(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg);

  int setmask() override;
  void init() override;
  void setup(int vflag) override;
  void end_of_step() override;
  double compute_scalar() override;
  double compute_vector(int n) override;
  int modify_param(int narg, char** arg) override;

 private:
  void look_at_joints();
  void look_at_contacts();
  void look_for_fastest_block();
  void choose();
  void set_step(double step);
  [[nodiscard]] double longest_stable(ContactStep free, ContactStep joined) const;
  [[nodiscard]] double springs_bear() const;
  [[nodiscard]] double dashpots_bear() const;
  [[nodiscard]] double longest_resolving() const;

  std::string where_;
  double fraction_, dashpot_fraction_;     // [-]
  double collision_, shortest_, longest_;  // [s]
  double collision_speed_;                 // [m/s], 0: whatever the speed
  double fastest_ = 0.0;                   // block at the last look [m/s]
  int joints_every_;                       // looks between two looks at the joints, 0: never again
  Breaking breaking_;
  StepLimit* joints_ = nullptr;                      // looked up in every init(); null: no joints
  double joint_step_;                                // of the last look [s]
  std::array<double, kContactSteps> contact_steps_;  // of the last look [s]
  int looks_ = 0;                                    // since that at the joints
  int known_changes_ = -1;  // of the joints' stiffness at the last look at them
  int changes_ = 0, products_ = 0;
};

}  // namespace muckpile
