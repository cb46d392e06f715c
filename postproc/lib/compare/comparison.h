// SPDX-License-Identifier: GPL-2.0-or-later
// Whether two runs have the same figures within tolerances, quantity by quantity.
// Scope: the first run is the reference; nothing is printed here.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "compare/run_figures.h"

namespace muckpile {

struct Tolerance {
  double relative = 0.0;  // of the reference: of a table's column, of its largest magnitude
  double absolute = 0.0;  // in the quantity's unit
  // The larger of the two.
  [[nodiscard]] double allowed(double reference) const;
};

struct CompareOptions {
  Tolerance general;
  std::map<std::string, Tolerance> named;          // KEY, TABLE or TABLE:COLUMN
  std::map<std::string, Tolerance> of_the_case{};  // as `named`, but a name may be in neither run
  std::vector<std::string> ignored;                // as the names of `named`
};

struct ComparedQuantity {
  std::string name;                           // KEY or TABLE:COLUMN
  std::string a, b;                           // as text; "missing" where a run does not have it
  std::optional<double> difference, allowed;  // of numbers
  std::string place;                          // "x_m = 3.5": where a table's column differs most
  bool same;
};

// "KEY=RELATIVE" or "KEY=RELATIVE,ABSOLUTE". Throws InputError.
std::pair<std::string, Tolerance> parse_tolerance(const std::string& words);

// The tolerances of an expected.json (figures/expected.h), each absolute.
std::map<std::string, Tolerance> tolerances_of_case(const std::filesystem::path& expected);

// Keys that tell how a run went and not what came of it. They count if they have a tolerance of
// their own.
const std::vector<std::string>& keys_of_the_computation();

// By name, summary first. Throws InputError for a name in the options that neither run has.
std::vector<ComparedQuantity> compare_runs(const RunFigures& a, const RunFigures& b,
                                           const CompareOptions& options);

}  // namespace muckpile
