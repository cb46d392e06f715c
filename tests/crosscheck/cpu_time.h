// SPDX-License-Identifier: GPL-2.0-or-later
// CPU time of a run, as crosscheck.sh leaves it beside the run's files.
// Scope: one process each; set-up and output included.
#pragma once

#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace muckpile::crosscheck {

/// User and system time together [s]. Throws std::runtime_error without the two numbers in
/// `folder`/cpu_s.
inline double cpu_seconds(const std::filesystem::path& folder) {
  std::ifstream file(folder / "cpu_s");
  double user = 0.0, system = 0.0;
  if (!(file >> user >> system))
    throw std::runtime_error((folder / "cpu_s").string() + ": has no CPU time");
  return user + system;
}

}  // namespace muckpile::crosscheck
