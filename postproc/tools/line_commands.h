// SPDX-License-Identifier: GPL-2.0-or-later
// Sub-commands of muckpile-post that measure any geometry: section, over, trough.
// Scope: command line only.
#pragma once

#include <CLI/CLI.hpp>

namespace muckpile {

void add_line_commands(CLI::App& app);

}  // namespace muckpile
