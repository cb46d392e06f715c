// SPDX-License-Identifier: GPL-2.0-or-later
// Sub-command sweep of muckpile-post.
// Scope: command line and screen; sweep/sweep_report.h does the work.
#pragma once

#include <CLI/CLI.hpp>

namespace muckpile {

void add_sweep_command(CLI::App& app);

}  // namespace muckpile
