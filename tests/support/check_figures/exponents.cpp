// SPDX-License-Identifier: GPL-2.0-or-later
// Exponents of a figure's answers.
// Scope: see the header.
#include "check_figures/exponents.h"

#include <cmath>
#include <map>

#include "args/csv_table.h"
#include "args/input_error.h"

namespace muckpile::check {

Json exponents(const std::filesystem::path& path) {
  const CsvTable table = CsvTable::read(path);
  const auto positive = [&table](size_t row, const char* name) {
    const double value = table.number(row, table.column(name));
    if (value <= 0.0)
      throw InputError(table.where(row) + name + " must be > 0, got " + text_of(value));
    return value;
  };
  std::map<std::string, int> rows_of;
  for (size_t row = 0; row < table.rows(); ++row) ++rows_of[std::string(table.word(row, table.column("name")))];
  Json result = Json::object();
  for (size_t row = 0; row < table.rows(); ++row) {
    const std::string name(table.word(row, table.column("name")));
    const double factor = positive(row, "factor");
    if (factor == 1.0) throw InputError(table.where(row) + "factor must not be 1");
    const double exponent =
        std::log(positive(row, "value") / positive(row, "base")) / std::log(factor);
    result[name + (rows_of[name] > 1 ? "_at_" + text_of(factor) : "") + "_exponent"] = exponent;
  }
  if (result.empty()) refuse(path.string(), "has no row");
  return result;
}

}  // namespace muckpile::check
