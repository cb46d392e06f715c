// SPDX-License-Identifier: GPL-2.0-or-later
// Lists for the log that may be long: the first three lines, and how many more there are.
// Scope: text only.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace muckpile {

/// Each line ends itself. `start` and `what` stand before and behind "and N more".
inline std::string first_lines(const std::vector<std::string>& lines, const std::string& start,
                               const std::string& what) {
  constexpr std::size_t kLines = 3;
  std::string text;
  for (std::size_t k = 0; k < std::min(lines.size(), kLines); ++k) text += lines[k];
  if (lines.size() <= kLines) return text;
  return text + start + "and " + std::to_string(lines.size() - kLines) + " more " + what + '\n';
}

}  // namespace muckpile
