// SPDX-License-Identifier: GPL-2.0-or-later
// Hole tables as text: numbers that people can read, and a table with other columns.
// Scope: text only; what the columns mean is hole_table.h.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "args/csv_table.h"

namespace muckpile {

/// To a nanometre or a nanosecond: far finer than any drill or detonator.
inline constexpr double kFinestStep = 1e-9;

/// The number to the next multiple of `step`, without needless digits.
[[nodiscard]] std::string stepped_text(double value, double step = kFinestStep);

/// A column's name and its field in each row.
using NewColumn = std::pair<std::string, std::vector<std::string>>;

/// The table with these columns in place of those of the same names, or behind the last. Remarks
/// come first.
[[nodiscard]] std::string with_columns(const CsvTable& csv, const std::vector<NewColumn>& columns);

}  // namespace muckpile
