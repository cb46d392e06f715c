// SPDX-License-Identifier: GPL-2.0-or-later
// What was measured at a blast, and how well.
// Scope: see the header.
#include "calibrate/measured.h"

#include <algorithm>

#include "args/csv_table.h"
#include "args/input_error.h"

namespace muckpile {

std::vector<MeasuredFigure> read_measured(const std::filesystem::path& path) {
  const CsvTable table = CsvTable::read(path);
  table.require_known_columns({"figure", "value", "uncertainty"});
  const size_t key = table.column("figure"), value = table.column("value"),
               uncertainty = table.column("uncertainty");
  if (table.rows() == 0) refuse(path.string(), "has no row");
  std::vector<MeasuredFigure> all;
  for (size_t row = 0; row < table.rows(); ++row) {
    const MeasuredFigure one{std::string(table.word(row, key)), table.number(row, value),
                             table.number(row, uncertainty)};
    if (one.key.empty())
      throw InputError(table.where(row) + "figure must be a key of summary.json");
    if (std::ranges::find(all, one.key, &MeasuredFigure::key) != all.end())
      throw InputError(table.where(row) + "figure '" + one.key + "' is given twice");
    if (!(one.uncertainty > 0.0))
      throw InputError(table.where(row) + "uncertainty must be > 0, a standard deviation, got '" +
                       std::string(table.word(row, uncertainty)) + "'");
    all.push_back(one);
  }
  return all;
}

}  // namespace muckpile
