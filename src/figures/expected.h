// SPDX-License-Identifier: GPL-2.0-or-later
// What a case is expected to give: {"case": TEXT, "vars": TEXT, "expected": [ROW, ...]} with
// ROW = {"quantity": NAME, "value": V, "tolerance": T, "why": TEXT}; `vars` may be left out.
// Scope: a file with any other key, a key or row missing, a value of another type or a quantity
// twice is refused with its place, so that no row can be passed over.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "figures/figures.h"

namespace muckpile::check {

struct ExpectedRow {
  std::string quantity;
  double value, tolerance;
};

struct Expected {
  std::optional<std::string> vars;  ///< -var NAME VALUE ..., for the run
  std::vector<ExpectedRow> rows;    ///< one at least
};

[[nodiscard]] Expected read_expected(const std::filesystem::path& path);

/// Prints every row with what was found: in the first of `files` that has the quantity. False if
/// one is missing, no finite number, or outside its tolerance.
[[nodiscard]] bool compare(const Expected& expected, const std::vector<FigureFile>& files);

}  // namespace muckpile::check
