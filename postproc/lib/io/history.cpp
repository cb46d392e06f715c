// SPDX-License-Identifier: GPL-2.0-or-later
// The few totals that the summary needs from a run's dump/history.csv.
// Scope: no time series is kept.
#include "io/history.h"

#include <algorithm>
#include <cmath>

#include "args/csv_table.h"
#include "args/input_error.h"

namespace muckpile {

History read_history(const std::filesystem::path& path) {
  const CsvTable table = CsvTable::read(path);
  if (table.rows() == 0) throw InputError(path.string() + ": holds no rows");
  const size_t joints = table.column("joints");
  const size_t broken = table.column("joints_broken");
  const size_t fastest = table.column("fastest_block_m_s");
  const size_t balance = table.column("balance_error");
  History history;
  for (size_t row = 0; row < table.rows(); ++row) {
    history.fastest_block = std::max(history.fastest_block, table.number(row, fastest));
    history.worst_balance_error =
        std::max(history.worst_balance_error, std::abs(table.number(row, balance)));
  }
  const double total = table.number(0, joints);
  if (total > 0.0) history.joints_broken_fraction = table.number(table.rows() - 1, broken) / total;
  return history;
}

}  // namespace muckpile
