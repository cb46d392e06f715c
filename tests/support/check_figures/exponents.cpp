// SPDX-License-Identifier: GPL-2.0-or-later
// Exponents of a figure's answers.
// Scope: see the header.
#include "check_figures/exponents.h"

#include <cmath>
#include <map>

#include "args/csv_table.h"
#include "args/input_error.h"
#include "check_figures/positive_number.h"

namespace muckpile::check {
namespace {

bool given(const CsvTable& table, size_t row, const char* name) {
  return !table.word(row, table.column(name)).empty();
}

/// Name and value of the figure of a row.
std::pair<std::string, double> answer_of(const CsvTable& table, size_t row, bool by_factor) {
  const std::string name(table.word(row, table.column("name")));
  const double value = positive_number(table, row, "value");
  if (!given(table, row, "factor") && !given(table, row, "base")) return {name, value};
  const double ratio = value / positive_number(table, row, "base");
  if (!given(table, row, "factor")) return {name + "_ratio", ratio};
  const double factor = positive_number(table, row, "factor");
  if (factor == 1.0) throw InputError(table.where(row) + "factor must not be 1");
  return {name + (by_factor ? "_at_" + text_of(factor) : "") + "_exponent",
          std::log(ratio) / std::log(factor)};
}

}  // namespace

Json exponents(const std::filesystem::path& path) {
  const CsvTable table = CsvTable::read(path);
  std::map<std::string, int> rows_of;
  for (size_t row = 0; row < table.rows(); ++row)
    ++rows_of[std::string(table.word(row, table.column("name")))];
  Json result = Json::object();
  for (size_t row = 0; row < table.rows(); ++row) {
    const std::string name(table.word(row, table.column("name")));
    const auto [figure, value] = answer_of(table, row, rows_of[name] > 1);
    if (!result.emplace(figure, value).second)
      throw InputError(table.where(row) + figure + " is there twice");
  }
  if (result.empty()) refuse(path.string(), "has no row");
  return result;
}

}  // namespace muckpile::check
