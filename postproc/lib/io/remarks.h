// SPDX-License-Identifier: GPL-2.0-or-later
// Numbers in the first line of a file of a run, "# step=1000 time_s=0.005 run=...".
// Scope: the remarks of a table that has been read.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "args/csv_table.h"

namespace muckpile {

// The number after "<key>="; nothing where there is none. Throws InputError, naming `file`, where
// it is no number, and without find_ also where there is none.
std::optional<double> find_remark_number(const CsvTable& table, const std::string& file,
                                         std::string_view key);
double remark_number(const CsvTable& table, const std::string& file, std::string_view key);

}  // namespace muckpile
