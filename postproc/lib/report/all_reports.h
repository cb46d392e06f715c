// SPDX-License-Identifier: GPL-2.0-or-later
// Sub-command all: every report that a run's scene has, with the defaults of each.
// Scope: which reports, and their key figures as text; reports.h and plan_report.h make them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "io/result_folder.h"

namespace muckpile {

// The names of the sub-commands for the scene of a run, in the order in which they are made.
// The polyhedra of all snapshots, some hundred MB, are among them only `with_series`. Throws InputError
// if its case is not bench, crater, heap or other.
std::vector<std::string> reports_of(const ResultFolder& folder, bool with_series);

// Makes one of them. Throws NotMeasurable where it has no measures for the scene.
void make_report(const ResultFolder& folder, const std::string& name);

// A line for each key of summary.json with its value.
std::string summary_lines(const ResultFolder& folder);

// The pictures in the folder itself, by name.
std::vector<std::filesystem::path> pictures_in(const ResultFolder& folder);

}  // namespace muckpile
