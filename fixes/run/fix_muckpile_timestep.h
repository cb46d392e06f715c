// SPDX-License-Identifier: GPL-2.0-or-later
// fix muckpile/timestep: keeps the time step a given share of the longest stable one.
// Scope: joints and sphere contacts of blocks, with each other and with fix muckpile/wall;
// LIGGGHTS' walls do not count.
#pragma once

#include <fix.h>

#include <array>
#include <string>

#include "bond/linear/stable_step.h"
#include "fixes/interfaces/contact_steps.h"
#include "fixes/interfaces/step_limit.h"
#include "state/encoding.h"

namespace muckpile {

/// What the words and fix_modify say.
struct StepSettings {
  double fraction = 0.0, dashpot_fraction = 0.0;          ///< [-]
  double collision = 0.0, shortest = 0.0, longest = 0.0;  ///< [s]
  double collision_speed = 0.0;                           ///< [m/s], 0: whatever the speed
  int every = 1;                                          ///< steps between looks
  int joints_every = 0;   ///< looks between two looks at the joints, 0: never again
  int contact_every = 1;  ///< most steps from one act of the contacts to the next
  Breaking breaking = Breaking::possible;
  bool operator==(const StepSettings&) const = default;
};
template <>
struct Stored<StepSettings> {
  static constexpr std::string_view kName = "step_settings";
  static constexpr int kVersion = 2;
  static auto fields(auto& settings) {
    return std::tie(settings.fraction, settings.dashpot_fraction, settings.collision,
                    settings.shortest, settings.longest, settings.collision_speed, settings.every,
                    settings.joints_every, settings.contact_every, settings.breaking);
  }
};

/// What the last look found.
struct StepLook {
  double joint_step = 0.0;                            // [s]
  std::array<double, kContactSteps> contact_steps{};  // [s]
  double fastest = 0.0;                               // block [m/s]
  int since_joints = 0;                               // checks since the look at the joints
  int since_contacts = 0;                             // and since that at the contacts
  int pace = 1;                                       // of the contacts [steps]
};
template <>
struct Stored<StepLook> {
  static constexpr std::string_view kName = "step_look";
  static constexpr int kVersion = 2;
  static auto fields(auto& look) {
    return std::tie(look.joint_step, look.contact_steps, look.fastest, look.since_joints,
                    look.since_contacts, look.pace);
  }
};

/// What a restart file holds of the fix.
struct StepState {
  StepSettings settings;
  double step = 0.0;        ///< [s]
  bool within_run = false;  ///< not between two runs
  StepLook look;
  int changes = 0, products = 0;
};
template <>
struct Stored<StepState> {
  static constexpr std::string_view kName = "step_state";
  static constexpr int kVersion = 1;
  static auto fields(auto& state) {
    return std::tie(state.settings, state.step, state.within_run, state.look, state.changes,
                    state.products);
  }
};

class FixMuckpileTimestep : public LAMMPS_NS::Fix {
 public:
  FixMuckpileTimestep(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg);

  int setmask() override;
  void pre_delete(bool unfixflag) override;
  void init() override;
  void setup(int vflag) override;
  void end_of_step() override;
  double compute_scalar() override;
  double compute_vector(int n) override;
  int modify_param(int narg, char** arg) override;
  void write_restart(FILE* file) override;
  void restart(char* state) override;

 private:
  void look_at_joints();
  void look_at_contacts();
  void look_for_fastest_block();
  void choose();
  void set_step(double step);
  void set_pace(int steps);
  [[nodiscard]] int pace() const;
  [[nodiscard]] double wanted() const;
  [[nodiscard]] bool goes_on_unchanged() const;
  [[nodiscard]] double longest_stable(ContactStep free, ContactStep joined) const;
  [[nodiscard]] double springs_bear() const;
  [[nodiscard]] double dashpots_bear() const;
  [[nodiscard]] double longest_resolving() const;

  std::string where_;
  StepSettings settings_;
  double cap_ = 1e30;  // longest step until it is told anew; not in restart files [s]
  StepLook look_;
  StepLimit* joints_ = nullptr;  // looked up in every init(); null: no joints
  int known_changes_ = -1;       // of the joints' stiffness at the last look at them
  int changes_ = 0, products_ = 0;
  bool set_up_ = false;             // the engine knows all that a new step is told to
  LAMMPS_NS::bigint read_at_ = -1;  // step of the restart file from which the run goes on
  StepState then_;                  // of that file
};

}  // namespace muckpile
