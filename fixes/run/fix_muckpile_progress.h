// SPDX-License-Identifier: GPL-2.0-or-later
// fix muckpile/progress: says how the blast goes, writes its history, and stops a run gone wrong.
// Scope: needs fix muckpile/ledger; every look costs one collective sum.
#pragma once

#include <fix.h>

#include <string>

#include "fixes/interfaces/state_writer.h"
#include "fixes/run/run_files.h"
#include "fixes/run/run_look.h"
#include "state/encoding.h"

namespace muckpile {

namespace engine {
class Bodies;
}
class KnownBlocks;
class EnergyAccount;
class JointDamage;

/// What a restart file holds of the fix.
struct ProgressState {
  double wall_clock = 0.0;  ///< that the run has taken so far [s]
};
template <>
struct Stored<ProgressState> {
  static constexpr std::string_view kName = "progress_state";
  static constexpr int kVersion = 1;
  static auto fields(auto& state) { return std::tie(state.wall_clock); }
};

class FixMuckpileProgress : public LAMMPS_NS::Fix, public StateWriter {
 public:
  FixMuckpileProgress(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg);

  int setmask() override;
  void init() override;
  void setup(int vflag) override;
  void end_of_step() override;
  void post_run() override;
  double compute_scalar() override;
  double compute_vector(int n) override;
  void write_restart(FILE* file) override;
  void restart(char* state) override;
  int modify_param(int narg, char** arg) override;
  std::string write_state() override;

 private:
  [[nodiscard]] std::string phase_of(const std::string& where, const std::string& typed) const;
  void look_if_due();
  [[nodiscard]] RunLook look();
  void look_at_blocks(RunLook& now) const;
  [[nodiscard]] bool has_entered_solid(const engine::Bodies& bodies, int b) const;
  void warn_of_solid(const RunLook& now);
  void warn_of_gone(const RunLook& now);
  void say(const RunLook& now) const;
  void write_history(const RunLook& now);
  void write_run(const RunLook& now) const;
  void stop_if_wrong(const RunLook& now);
  [[nodiscard]] bool still(const RunLook& now) const;
  [[noreturn]] void stop_with_restart(const std::string& why);

  EnergyAccount* ledger_ = nullptr;
  JointDamage* joints_ = nullptr;
  KnownBlocks* blocks_ = nullptr;
  std::string where_, folder_, phase_;
  std::string scene_;  // region, empty for all space
  std::string solid_;  // region, empty for none
  RunFiles files_;
  int every_;  // the engine looks up `nevery` only when a run is set up
  double time_end_, still_speed_, still_share_, fastest_allowed_, balance_allowed_;
  double wall_start_, phase_wall_start_ = 0.0, phase_time_start_ = 0.0;
  bool warned_of_solid_ = false, warned_of_gone_ = false;
  LAMMPS_NS::bigint read_at_ = -1;  // step of the restart file from which the run goes on
  LAMMPS_NS::bigint last_ = -1;     // step of the last row of the history
};

}  // namespace muckpile
