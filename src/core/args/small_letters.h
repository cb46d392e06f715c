// SPDX-License-Identifier: GPL-2.0-or-later
// A word in small letters, for words that may be written in either.
// Scope: plain ASCII; other characters stay as they are.
#pragma once

#include <algorithm>
#include <cctype>
#include <string>
#include <string_view>

namespace muckpile {

[[nodiscard]] inline std::string in_small_letters(std::string_view word) {
  std::string small(word);
  std::ranges::transform(small, small.begin(), [](unsigned char c) { return std::tolower(c); });
  return small;
}

}  // namespace muckpile
