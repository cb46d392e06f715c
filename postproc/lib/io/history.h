// SPDX-License-Identifier: GPL-2.0-or-later
// The few totals that the summary needs from a run's dump/history.csv.
// Scope: no time series is kept.
#pragma once

#include <filesystem>

namespace muckpile {

struct History {
  double joints_broken_fraction = 0.0;  // at the end, of the joints at the start
  double fastest_block = 0.0;           // over all rows [m/s]
  double worst_balance_error = 0.0;     // largest magnitude over all rows
};

// Throws InputError, naming file and line, if a row is malformed or there is none.
History read_history(const std::filesystem::path& path);

}  // namespace muckpile
