// SPDX-License-Identifier: GPL-2.0-or-later
// Sub-command fragments of muckpile-post.
// Scope: command line only; report/ does the work.
#pragma once

#include <CLI/CLI.hpp>

namespace muckpile {

void add_fragments_command(CLI::App& app);

}  // namespace muckpile
