// SPDX-License-Identifier: GPL-2.0-or-later
// Sub-commands of muckpile-post that measure a pile or crater: profile, crater, heap, rows,
// heights. Scope: command line only; report/ does the work.
#pragma once

#include <CLI/CLI.hpp>

namespace muckpile {

void add_pile_commands(CLI::App& app);

}  // namespace muckpile
