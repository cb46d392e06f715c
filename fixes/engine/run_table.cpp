// SPDX-License-Identifier: GPL-2.0-or-later
// A CSV table that a run writes row by row.
// Scope: see the header.
#include "fixes/engine/run_table.h"

#include <comm.h>
#include <error.h>
#include <lammps.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <fstream>

#include "fixes/engine/output_file.h"

namespace muckpile::engine {

namespace {

/// The step that a row begins with; -1 where it begins with none.
std::int64_t step_of(const std::string& row) {
  std::int64_t step = -1;
  const char* const end = row.data() + std::min(row.find(','), row.size());
  const auto [stop, fault] = std::from_chars(row.data(), end, step);
  return fault == std::errc() && stop == end ? step : -1;
}

}  // namespace

/// A line that was not cut off, nor written on by another.
bool RunTable::is_whole_row(const std::string& line, const std::string& run_id) const {
  return line.ends_with(',' + run_id) && step_of(line) >= 0 &&
         std::ranges::count(line, ',') == std::ranges::count(header_, ',');
}

std::string RunTable::rows_before(const std::string& run_id, std::int64_t step) const {
  std::error_code unheeded;
  if (step == 0 || !std::filesystem::is_regular_file(file_, unheeded)) return "";
  std::ifstream in(file_);
  std::string line, kept;
  bool good = std::getline(in, line) && line + '\n' == header_;
  int dropped = 0;
  while (std::getline(in, line)) {
    if (good && is_whole_row(line, run_id)) {
      if (step_of(line) >= step) break;
      kept += line + '\n';
    } else {
      good = false;
      ++dropped;
    }
  }
  if (dropped > 0) {
    lmp_->error->warning(
        FLERR, (where_ + ": '" + file_ + "' goes on without its last " + std::to_string(dropped) +
                " rows: the first of them is damaged, or of another run")
                   .c_str());
  }
  return kept;
}

void RunTable::begin(const std::string& run_id, std::int64_t first_step) {
  if (begun_) return;
  begun_ = true;
  const std::string before = lmp_->comm->me == 0 ? rows_before(run_id, first_step) : "";
  write_file(*lmp_, where_, file_, header_ + before + pending_);
  pending_.clear();
}

void RunTable::add(const std::string& rows) {
  if (begun_) {
    append_to_file(*lmp_, where_, file_, rows);
  } else {
    pending_ += rows;
  }
}

}  // namespace muckpile::engine
