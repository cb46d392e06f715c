// SPDX-License-Identifier: GPL-2.0-or-later
// Sub-command survey of muckpile-post.
// Scope: command line and screen; report/survey_report.cpp does the work.
#pragma once

#include <CLI/CLI.hpp>

namespace muckpile {

void add_survey_command(CLI::App& app);

}  // namespace muckpile
