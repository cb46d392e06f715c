// SPDX-License-Identifier: GPL-2.0-or-later
// Sub-command damage of muckpile-post.
// Scope: command line only; report/damage_report.cpp does the work.
#pragma once

#include <CLI/CLI.hpp>

namespace muckpile {

void add_damage_command(CLI::App& app);

}  // namespace muckpile
