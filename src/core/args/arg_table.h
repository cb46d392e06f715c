// SPDX-License-Identifier: GPL-2.0-or-later
// The keyword table of one style: the single source of its parser, its messages and its docs table.
// Scope: `keyword value` pairs in any order, and keywords that take several raw words.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "args/range.h"

namespace muckpile {

/// One row of the table.
struct Keyword {
  enum class Kind { real, integer, word, flag, group };
  std::string name{};
  Kind kind = Kind::word;
  std::string unit{};                     ///< "" for a pure number
  Range range{};                          ///< real and integer only
  std::vector<std::string> choices{};     ///< word only; empty: any word
  std::optional<std::string> fallback{};  ///< as a user would type it; none: required
  std::size_t words_min = 1;              ///< group only
  std::size_t words_max = 1;              ///< group only
  bool repeatable = false;                ///< group only
  std::string text{};                     ///< what it means, for the docs
};

/// Rows are added at start-up by the style's author: a duplicate name or a fallback that breaks its
/// own rule throws std::logic_error.
class ArgTable {
 public:
  explicit ArgTable(std::string style);

  /// Real number [unit]; no fallback: the keyword is required.
  ArgTable& real(const std::string& name, const std::string& unit, Range range,
                 std::optional<double> fallback, const std::string& text);
  /// Whole number [unit]; no fallback: required.
  ArgTable& integer(const std::string& name, const std::string& unit, Range range,
                    std::optional<long> fallback, const std::string& text);
  /// One word out of `choices`, or any word if that is empty; no fallback: required.
  ArgTable& word(const std::string& name, const std::vector<std::string>& choices,
                 const std::optional<std::string>& fallback, const std::string& text);
  /// yes or no.
  ArgTable& flag(const std::string& name, bool fallback, const std::string& text);
  /// `words_min` to `words_max` raw words, e.g. `hole x y z x y z r`; always optional. The group
  /// ends at words_max or before the next keyword of the table; after words_min also before a word
  /// that resembles one, so that a typing error is told as such.
  ArgTable& group(const std::string& name, std::size_t words_min, std::size_t words_max,
                  bool repeatable, const std::string& text);

  [[nodiscard]] const std::string& style() const { return style_; }
  [[nodiscard]] const std::vector<Keyword>& keywords() const { return keywords_; }
  [[nodiscard]] std::vector<std::string> names() const;
  /// Row of that name, nullptr if there is none.
  [[nodiscard]] const Keyword* find(const std::string& name) const;
  /// The docs' parameter table: keyword, unit, range, default, meaning.
  [[nodiscard]] std::string markdown() const;

 private:
  ArgTable& add(Keyword keyword);

  std::string style_;
  std::vector<Keyword> keywords_;
};

}  // namespace muckpile
