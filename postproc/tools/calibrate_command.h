// SPDX-License-Identifier: GPL-2.0-or-later
// Sub-command calibrate of muckpile-post: fit and check.
// Scope: its words; calibrate/ does the work.
#pragma once

#include <CLI/CLI.hpp>

namespace muckpile {

/// `status` becomes that of check: 0 all figures agree, 1 some differ, 2 a file cannot be read.
void add_calibrate_command(CLI::App& app, int& status);

}  // namespace muckpile
