// SPDX-License-Identifier: GPL-2.0-or-later
// Sub-command compare of muckpile-post.
// Scope: command line and screen; compare/comparison.h does the work.
#pragma once

#include <CLI/CLI.hpp>

namespace muckpile {

// Leaves in `status` the program's: 0 if the runs are the same, 1 if they differ, 2 if a file
// cannot be read or an option names nothing.
void add_compare_command(CLI::App& app, int& status);

}  // namespace muckpile
