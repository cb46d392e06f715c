// SPDX-License-Identifier: GPL-2.0-or-later
// history.csv and run.json of a run.
// Scope: see the header.
#include "fixes/run/run_files.h"

#include <comm.h>
#include <error.h>
#include <lammps.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string_view>

#include "fixes/engine/output_file.h"

namespace muckpile {
namespace {

/// A line that was not cut off, nor written on by another.
bool is_whole_row(const std::string& line, const std::string& run_id) {
  const std::string_view header = RunFiles::kHeader;
  return line.ends_with(',' + run_id) &&
         std::ranges::count(line, ',') == std::ranges::count(header, ',');
}

}  // namespace

std::string RunFiles::rows_before(const std::string& run_id, std::int64_t step) const {
  const std::string file = history();
  std::error_code unheeded;
  if (step == 0 || !std::filesystem::is_regular_file(file, unheeded)) return "";
  std::ifstream in(file);
  std::string line, kept;
  bool good = std::getline(in, line) && line + '\n' == kHeader;
  int dropped = 0;
  while (std::getline(in, line)) {
    if (good && is_whole_row(line, run_id)) {
      if (std::atoll(line.c_str()) >= step) break;
      kept += line + '\n';
    } else {
      good = false;
      ++dropped;
    }
  }
  if (dropped > 0) {
    lmp_->error->warning(
        FLERR, (where_ + ": '" + file + "' goes on without its last " + std::to_string(dropped) +
                " rows: the first of them is damaged, or of another run")
                   .c_str());
  }
  return kept;
}

/// What an earlier start of this run left does not hold until this one ends.
void RunFiles::remove_own_run(const std::string& run_id) const {
  std::ifstream in(run());
  const auto left = nlohmann::json::parse(in, nullptr, false);
  std::error_code unheeded;
  if (left.is_object() && left.value("run_id", nlohmann::json()) == run_id)
    std::filesystem::remove(run(), unheeded);
}

/// What an earlier start of this run left stays until a step is taken: a fix set up after this one
/// may refuse the run.
void RunFiles::begin(const std::string& run_id, std::int64_t first_step) {
  if (begun_) return;
  begun_ = true;
  const bool writes = lmp_->comm->me == 0;
  if (writes) remove_own_run(run_id);
  const std::string before = writes ? rows_before(run_id, first_step) : "";
  engine::write_file(*lmp_, where_, history(), kHeader + before + pending_rows_);
  pending_rows_.clear();
}

void RunFiles::add_row(const std::string& row) {
  if (begun_) {
    engine::append_to_file(*lmp_, where_, history(), row);
  } else {
    pending_rows_ += row;
  }
}

void RunFiles::write_run(const std::string& json) const {
  engine::write_file(*lmp_, where_, run(), json);
}

}  // namespace muckpile
