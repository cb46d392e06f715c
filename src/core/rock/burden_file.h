// SPDX-License-Identifier: GPL-2.0-or-later
// The burden of each hole along its charge as a CSV file, which muckpile-post draws.
// Scope: a row for each piece of each charge; lengths in metres, in the run's axes.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "rock/hole_burdens.h"

namespace muckpile {

struct BurdenFile {
  std::vector<HoleBurden> holes{};  ///< pieces and the hole in front alone
  double plan = 0.0;                ///< 0: not told [m]
};

/// Makes the folder if needed; throws InputError if the file cannot be written.
void write_burdens(const std::string& path, const BurdenFile& burdens, const std::string& run_id);

/// Throws InputError, with file and line, for a file that is not as write_burdens() makes it.
[[nodiscard]] BurdenFile read_burdens(const std::filesystem::path& path);

}  // namespace muckpile
