// SPDX-License-Identifier: GPL-2.0-or-later
// history.csv and run.json of a run.
// Scope: see the header.
#include "fixes/run/run_files.h"

#include <comm.h>
#include <lammps.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "fixes/engine/output_file.h"

namespace muckpile {

/// What an earlier start of this run left does not hold until this one ends.
void RunFiles::remove_own_run(const std::string& run_id) const {
  std::ifstream in(run());
  const auto left = nlohmann::json::parse(in, nullptr, false);
  std::error_code unheeded;
  if (left.is_object() && left.value("run_id", nlohmann::json()) == run_id)
    std::filesystem::remove(run(), unheeded);
}

void RunFiles::begin(const std::string& run_id, std::int64_t first_step) {
  if (history_.begun()) return;
  if (lmp_->comm->me == 0) remove_own_run(run_id);
  history_.begin(run_id, first_step);
}

void RunFiles::write_run(const std::string& json) const {
  engine::write_file(*lmp_, where_, run(), json);
}

}  // namespace muckpile
