// SPDX-License-Identifier: GPL-2.0-or-later
// A table of a run as curves over its first column, so that tables on other grids can be compared.
// Scope: numbers only; straight lines between the rows, beyond them the value of the last row.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "measure/scan_polygon.h"

namespace muckpile {

struct TableCurves {
  std::string over;                                    // name of the first column
  std::map<std::string, std::vector<Vec2>> of_column;  // points by name; empty fields left out
};

// Throws InputError, naming file and line, where the table is cut, holds no row, a field is no
// number, or the first column falls.
TableCurves read_curves(const std::filesystem::path& path);

// `curve` holds one point at least.
double value_at(const std::vector<Vec2>& curve, double x);

struct FarthestApart {
  double x, a, b;  // where, and the two values there
};

// Over the points of both; a tie goes to the least x. Both hold one point at least.
FarthestApart farthest_apart(const std::vector<Vec2>& a, const std::vector<Vec2>& b);

}  // namespace muckpile
