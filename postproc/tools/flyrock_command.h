// SPDX-License-Identifier: GPL-2.0-or-later
// Sub-command flyrock of muckpile-post.
// Scope: command line and screen; report/flyrock_report.cpp does the work.
#pragma once

#include <CLI/CLI.hpp>

namespace muckpile {

void add_flyrock_command(CLI::App& app);

}  // namespace muckpile
