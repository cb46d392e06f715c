// SPDX-License-Identifier: GPL-2.0-or-later
// Sub-command run-id of muckpile-post, for ./muckpile sweep; --help does not list it.
// Scope: command line only.
#pragma once

#include <CLI/CLI.hpp>

namespace muckpile {

void add_run_id_command(CLI::App& app);

}  // namespace muckpile
