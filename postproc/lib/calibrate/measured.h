// SPDX-License-Identifier: GPL-2.0-or-later
// What was measured at a blast, and how well.
// Scope: a table of keys of summary.json; values and uncertainties in the key's unit.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace muckpile {

struct MeasuredFigure {
  std::string key;     // of summary.json
  double value;        // [the key's unit]
  double uncertainty;  // standard deviation, > 0 [the key's unit]
};

// Columns figure, value and uncertainty, a row per figure. Throws InputError, with file and line,
// on other columns, a figure that stands there twice, an uncertainty that is not > 0, or no row.
[[nodiscard]] std::vector<MeasuredFigure> read_measured(const std::filesystem::path& path);

}  // namespace muckpile
