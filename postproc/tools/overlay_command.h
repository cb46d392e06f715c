// SPDX-License-Identifier: GPL-2.0-or-later
// Sub-command overlay of muckpile-post.
// Scope: its words; sweep/overlay_report.h does the work.
#pragma once

#include <CLI/CLI.hpp>

namespace muckpile {

void add_overlay_command(CLI::App& app);

}  // namespace muckpile
