// SPDX-License-Identifier: GPL-2.0-or-later
// Sub-command sweep: tables and plots of the runs of ./muckpile sweep.
// Scope: the sweep's folder; the folders of its runs are read only.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace muckpile {

// Writes sweep.csv, sweep_mean.csv, sweep_fit.csv and sweep.png; the latter two of `figures`, or,
// where none are named, of those that suit the kind of scene. Throws InputError as read_sweep does,
// and for a figure that no run has. Gives back what it has written.
std::vector<std::filesystem::path> report_sweep(const std::filesystem::path& folder,
                                                const std::vector<std::string>& figures);

}  // namespace muckpile
