// SPDX-License-Identifier: GPL-2.0-or-later
// The known word that a mistyped one most likely meant.
// Scope: plain ASCII words of a keyword table; short lists.
#pragma once

#include <string>
#include <vector>

namespace muckpile {

/// Edits (insert, delete, replace, swap of neighbours) that turn one word into the other.
[[nodiscard]] std::size_t edit_distance(const std::string& a, const std::string& b);

/// Nearest known word within a third of its length in edits, or the only one that starts with
/// `word`, capital and small letters being the same; "" if nothing is near.
[[nodiscard]] std::string closest_word(const std::string& word,
                                       const std::vector<std::string>& known);

/// "; did you mean 'x'?" or "".
[[nodiscard]] std::string did_you_mean(const std::string& word,
                                       const std::vector<std::string>& known);

/// "a, b, c".
[[nodiscard]] std::string joined(const std::vector<std::string>& words,
                                 const std::string& separator = ", ");

}  // namespace muckpile
