// SPDX-License-Identifier: GPL-2.0-or-later
// Tables against those of golden/.
// Scope: what a table holds is worked out in the tests of each sub-command; here no column, unit,
// order or digit may change unseen. With MUCKPILE_WRITE_GOLDEN set the files are written anew.
#pragma once

#include <filesystem>
#include <string>

namespace muckpile::testing {

// Line by line, as empty fields count; numbers to their last digit. `name` without its extension.
void expect_golden(const std::filesystem::path& made, const std::string& name);

}  // namespace muckpile::testing
