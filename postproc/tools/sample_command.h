// SPDX-License-Identifier: GPL-2.0-or-later
// Sub-command sample of muckpile-post.
// Scope: command line and screen; sweep/latin_hypercube.h does the work.
#pragma once

#include <CLI/CLI.hpp>

namespace muckpile {

void add_sample_command(CLI::App& app);

}  // namespace muckpile
