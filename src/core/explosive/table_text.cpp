// SPDX-License-Identifier: GPL-2.0-or-later
// Text of hole tables; see the header.
#include "explosive/table_text.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace muckpile {
namespace {

const NewColumn* find(const std::vector<NewColumn>& columns, std::string_view name) {
  const auto at = std::ranges::find_if(
      columns, [&](const NewColumn& column) { return is_same_column(column.first, name); });
  return at == columns.end() ? nullptr : &*at;
}

}  // namespace

std::string stepped_text(double value, double step) {
  const double per_unit = std::round(1.0 / step);
  const double rounded = std::round(value * per_unit) * step;
  std::ostringstream text;
  text.precision(12);
  text << (rounded == 0.0 ? 0.0 : rounded);
  return text.str();
}

std::string with_columns(const CsvTable& csv, const std::vector<NewColumn>& columns) {
  std::ostringstream text;
  for (const std::string_view remark : csv.remarks()) text << '#' << remark << '\n';
  std::vector<const NewColumn*> behind;
  for (const NewColumn& column : columns) {
    if (!csv.find_column(column.first)) behind.push_back(&column);
  }
  for (std::size_t k = 0; k < csv.header().size(); ++k)
    text << (k > 0 ? "," : "") << csv.header()[k];
  for (const NewColumn* column : behind) text << ',' << column->first;
  text << '\n';
  for (std::size_t row = 0; row < csv.rows(); ++row) {
    for (std::size_t k = 0; k < csv.header().size(); ++k) {
      const NewColumn* other = find(columns, csv.header()[k]);
      text << (k > 0 ? "," : "");
      if (other != nullptr) {
        text << other->second.at(row);
      } else {
        text << csv.word(row, k);
      }
    }
    for (const NewColumn* column : behind) text << ',' << column->second.at(row);
    text << '\n';
  }
  return text.str();
}

}  // namespace muckpile
