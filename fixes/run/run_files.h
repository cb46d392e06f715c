// SPDX-License-Identifier: GPL-2.0-or-later
// history.csv and run.json of a run, which may go on from what an earlier start of it left.
// Scope: files alone; what they say is the caller's. Rank 0 writes, every call is collective.
#pragma once

#include <cstdint>
#include <string>
#include <utility>

#include "fixes/engine/run_table.h"

namespace LAMMPS_NS {
class LAMMPS;
}

namespace muckpile {

class RunFiles {
 public:
  RunFiles() = default;
  /// `where` starts every message; `folder` exists.
  RunFiles(LAMMPS_NS::LAMMPS& lmp, std::string where, std::string folder)
      : lmp_(&lmp),
        where_(std::move(where)),
        folder_(std::move(folder)),
        history_(lmp, where_, folder_ + "/history.csv", kHeader) {}

  /// Once, as the first step is taken: keeps the rows of that run from steps before `first_step`,
  /// and removes its run.json.
  void begin(const std::string& run_id, std::int64_t first_step);
  /// A line of history.csv, with its end; in the columns of kHeader. Waits for begin().
  void add_row(const std::string& row) { history_.add(row); }
  void write_run(const std::string& json) const;

  static constexpr const char* kHeader =
      "step,time_s,timestep_s,phase,joints,joints_broken,fastest_block_m_s,kinetic_J,elastic_J,"
      "contact_elastic_J,"
      "gravity_J,blast_work_J,fracture_J,joint_friction_J,joint_damping_J,contact_friction_J,"
      "contact_"
      "damping_J,wall_J,quiet_J,sleep_J,given_J,"
      "balance_error,run_id\n";

 private:
  void remove_own_run(const std::string& run_id) const;
  [[nodiscard]] std::string run() const { return folder_ + "/run.json"; }

  LAMMPS_NS::LAMMPS* lmp_ = nullptr;
  std::string where_, folder_;
  engine::RunTable history_;
};

}  // namespace muckpile
