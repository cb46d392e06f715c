// SPDX-License-Identifier: GPL-2.0-or-later
// A large text in parts for all cores.
// Scope: whole lines, whatever they say.
#pragma once

#include <string_view>
#include <vector>

namespace muckpile {

// In order and without gaps, each a mebibyte and the rest of a line; the last one may be shorter.
std::vector<std::string_view> line_pieces(std::string_view text);

}  // namespace muckpile
