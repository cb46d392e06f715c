// SPDX-License-Identifier: GPL-2.0-or-later
// A CSV table that a run writes row by row, and that may go on from what an earlier start of the
// run left.
// Scope: text; the first column is the step, the last one the id of the run. Rank 0 writes, every
// call is collective.
#pragma once

#include <cstdint>
#include <string>
#include <utility>

namespace LAMMPS_NS {
class LAMMPS;
}

namespace muckpile::engine {

class RunTable {
 public:
  RunTable() = default;
  /// `where` starts every message; the folder of `file` exists; `header` ends its line.
  RunTable(LAMMPS_NS::LAMMPS& lmp, std::string where, std::string file, std::string header)
      : lmp_(&lmp), where_(std::move(where)), file_(std::move(file)), header_(std::move(header)) {}

  /// Once, as the first step is taken: what an earlier start left stays until then, as a fix set up
  /// after the caller may refuse the run. Of that run it keeps the rows of steps before
  /// `first_step`.
  void begin(const std::string& run_id, std::int64_t first_step);
  [[nodiscard]] bool begun() const { return begun_; }
  /// Whole lines, with their ends. They wait for begin().
  void add(const std::string& rows);

 private:
  [[nodiscard]] bool is_whole_row(const std::string& line, const std::string& run_id) const;
  [[nodiscard]] std::string rows_before(const std::string& run_id, std::int64_t step) const;

  LAMMPS_NS::LAMMPS* lmp_ = nullptr;
  std::string where_, file_, header_;
  std::string pending_;  // until a step is taken
  bool begun_ = false;
};

}  // namespace muckpile::engine
