// SPDX-License-Identifier: GPL-2.0-or-later
// The same table of several runs, one over the other: how its columns scatter.
// Scope: tables that are curves over their first column, and tables of rows with a name each.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "compare/table_curves.h"
#include "sweep/spread.h"

namespace muckpile {

struct OverlaidCurve {
  std::string column;
  std::vector<std::vector<Vec2>> runs;  // in the order of the tables
  std::vector<double> x;                // places of all runs, rising
  std::vector<Spread> spread;  // of the runs at each; beyond its ends a run has its last value
};

struct OverlaidCurves {
  std::string over;  // name of the first column
  std::vector<OverlaidCurve> curves;
};

// Of `columns`, or of all that hold a value in every table. Throws InputError as read_curves does,
// and on tables over different columns, or of which one lacks a column that was asked for.
[[nodiscard]] OverlaidCurves overlaid_curves(const std::vector<std::filesystem::path>& tables,
                                             const std::vector<std::string>& columns);

struct OverlaidRow {
  std::vector<std::string> names;  // what the row is of: polygon, hole, part of the bench
  std::string column;
  Spread spread;  // over the tables that have the row and a number there
};

struct OverlaidRows {
  std::vector<std::string> over;  // names of the naming columns; none: the table has no such
  std::vector<OverlaidRow> rows;
};

// Rows are the same where their naming columns hold the same words. Those are the leading ones of
// polygon, hole, row, gauge, level_low_m, level_high_m, from_face_m and to_face_m. Throws
// InputError where a file cannot be read or has other naming columns than the first.
[[nodiscard]] OverlaidRows overlaid_rows(const std::vector<std::filesystem::path>& tables,
                                         const std::vector<std::string>& columns);

// Whether the rows of a table are named, so that it is no curve.
[[nodiscard]] bool has_named_rows(const std::filesystem::path& table);

}  // namespace muckpile
