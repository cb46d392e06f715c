// SPDX-License-Identifier: GPL-2.0-or-later
// Strict reading of a style's words against its keyword table.
// Scope: every word is accounted for; anything else throws InputError with what to type instead.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "args/arg_table.h"

namespace muckpile {

/// The values of all keywords, defaults filled in, in the units of the table. Asking for a name or
/// kind that the table does not have is a programming error: std::logic_error.
class ArgValues {
 public:
  [[nodiscard]] double real(const std::string& name) const;
  [[nodiscard]] long integer(const std::string& name) const;
  [[nodiscard]] const std::string& word(const std::string& name) const;
  [[nodiscard]] bool flag(const std::string& name) const;
  /// True if the user typed the keyword.
  [[nodiscard]] bool given(const std::string& name) const;
  /// One entry per time the keyword was typed.
  [[nodiscard]] const std::vector<std::vector<std::string>>& groups(const std::string& name) const;
  /// The values as understood, one line each, for screen and log file.
  [[nodiscard]] std::string echo() const;

 private:
  friend ArgValues parse_args(const ArgTable& table, const std::string& where,
                              const std::vector<std::string>& words);
  struct Entry {
    Keyword keyword;
    bool given = false;
    std::string word;  ///< text of a single value
    double real = 0.0;
    long integer = 0;
    std::vector<std::vector<std::string>> groups;
  };
  ArgValues(std::string where, const ArgTable& table);
  void store(Entry& entry, const std::string& text) const;
  [[nodiscard]] const Entry& entry(const std::string& name, Keyword::Kind kind) const;

  std::string where_;
  std::vector<std::string> order_;
  std::map<std::string, Entry> entries_;
};

/// Reads `words` (the style's own fixed arguments already removed). `where` names style and id for
/// the messages, e.g. "fix muckpile/blast 'gas1'".
/// Throws InputError: unknown keyword, value missing, keyword twice, required keyword missing,
/// value outside its rule, wrong number of words in a group, words left over.
[[nodiscard]] ArgValues parse_args(const ArgTable& table, const std::string& where,
                                   const std::vector<std::string>& words);

}  // namespace muckpile
