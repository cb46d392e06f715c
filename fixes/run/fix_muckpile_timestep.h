// SPDX-License-Identifier: GPL-2.0-or-later
// fix muckpile/timestep: keeps the time step a given share of the longest stable one.
// Scope: joints and sphere contacts of blocks; walls are softer or equal, and stand back.
#pragma once

#include <fix.h>

#include <array>
#include <string>

#include "bond/linear/stable_step.h"
#include "fixes/interfaces/contact_steps.h"
#include "fixes/interfaces/step_limit.h"

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
  void write_restart(FILE* file) override;
  void restart(char* state) override;

 private:
  /// What the words and fix_modify say.
  struct Settings {
    double fraction, dashpot_fraction;    // [-]
    double collision, shortest, longest;  // [s]
    double collision_speed;               // [m/s], 0: whatever the speed
    int every;                            // steps between looks
    int joints_every;                     // looks between two looks at the joints, 0: never again
    Breaking breaking;
    bool operator==(const Settings&) const = default;
  };
  /// When the restart file was written.
  struct Then {
    Settings settings;
    double step;      // [s]
    bool within_run;  // not between two runs
  };
  /// What the last look found.
  struct Look {
    double joint_step;                                // [s]
    std::array<double, kContactSteps> contact_steps;  // [s]
    double fastest = 0.0;                             // block [m/s]
    int since_joints = 0;                             // looks since that at the joints
  };

  int find_joints();
  void look_at_joints();
  void look_at_contacts();
  void look_for_fastest_block();
  void choose();
  void set_step(double step);
  [[nodiscard]] double wanted() const;
  [[nodiscard]] bool goes_on_unchanged() const;
  [[nodiscard]] double longest_stable(ContactStep free, ContactStep joined) const;
  [[nodiscard]] double springs_bear() const;
  [[nodiscard]] double dashpots_bear() const;
  [[nodiscard]] double longest_resolving() const;

  std::string where_;
  Settings settings_{};
  Look look_{};
  StepLimit* joints_ = nullptr;  // looked up in every init(); null: no joints
  int known_changes_ = -1;       // of the joints' stiffness at the last look at them
  int changes_ = 0, products_ = 0;
  LAMMPS_NS::bigint read_at_ = -1;  // step of the restart file from which the run goes on
  Then then_{};
};

}  // namespace muckpile
