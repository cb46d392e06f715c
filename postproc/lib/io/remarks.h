// SPDX-License-Identifier: GPL-2.0-or-later
// Numbers in the first line of a file of a run, "# step=1000 time_s=0.005 run=...".
// Scope: the remarks of a table that has been read.
#pragma once

#include <string>
#include <string_view>

#include "args/csv_table.h"

namespace muckpile {

// The number after "<key>=". Throws InputError, naming `file`, where there is none.
double remark_number(const CsvTable& table, const std::string& file, std::string_view key);

}  // namespace muckpile
