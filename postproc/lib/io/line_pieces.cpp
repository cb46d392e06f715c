// SPDX-License-Identifier: GPL-2.0-or-later
// A large text in parts.
// Scope: see the header.
#include "io/line_pieces.h"

#include <algorithm>

namespace muckpile {

std::vector<std::string_view> line_pieces(std::string_view text) {
  constexpr size_t kPiece = 1 << 20;  // bytes
  std::vector<std::string_view> pieces;
  while (!text.empty()) {
    const size_t line_end = text.find('\n', std::min(kPiece, text.size() - 1));
    const size_t length = line_end == std::string_view::npos ? text.size() : line_end + 1;
    pieces.push_back(text.substr(0, length));
    text.remove_prefix(length);
  }
  return pieces;
}

}  // namespace muckpile
