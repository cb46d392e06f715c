// SPDX-License-Identifier: GPL-2.0-or-later
// Of what this program was built.
// Scope: words for records of runs.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace muckpile {

struct BuildInfo {
  /// Of the source; with "-dirty" behind it if tracked files differ from it; "unknown" without git.
  std::string commit;
  std::string compiler;
  std::vector<std::pair<std::string, std::string>> libraries;  ///< name and version
};

/// The version of MPI is that of the library in use, once MPI has started.
[[nodiscard]] BuildInfo build_info();

}  // namespace muckpile
