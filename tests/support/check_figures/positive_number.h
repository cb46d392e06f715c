// SPDX-License-Identifier: GPL-2.0-or-later
// Numbers of a table that must be > 0.
// Scope: refusals name the file, the row and the column.
#pragma once

#include "args/csv_table.h"
#include "args/input_error.h"
#include "figures/figures.h"

namespace muckpile::check {

[[nodiscard]] inline double positive_number(const CsvTable& table, size_t row, const char* column) {
  const double value = table.number(row, table.column(column));
  if (value <= 0.0)
    throw InputError(table.where(row) + column + " must be > 0, got " + text_of(value));
  return value;
}

}  // namespace muckpile::check
