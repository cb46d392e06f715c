// SPDX-License-Identifier: GPL-2.0-or-later
// Strict reading of a style's words against its keyword table.
// Scope: see parse_args.h.
#include "args/parse_args.h"

#include <algorithm>
#include <cctype>
#include <stdexcept>
#include <utility>

#include "args/input_error.h"
#include "args/numbers.h"
#include "args/suggestion.h"

namespace muckpile {
namespace {

bool looks_like_a_number(const std::string& word) {
  const std::size_t first = word.find_first_not_of("+-.");
  return first != std::string::npos && std::isdigit(static_cast<unsigned char>(word[first])) != 0;
}

[[noreturn]] void refuse_unknown(const ArgTable& table, const std::string& where,
                                 const std::vector<std::string>& words, std::size_t at) {
  const std::vector<std::string> known = table.names();
  const std::string list = " (known: " + joined(known) + ")";
  if (looks_like_a_number(words[at])) {
    const std::string after = at == 0 ? "" : " after '" + words[at - 1] + "'";
    throw InputError(where + ": expected a keyword" + after + ", got '" + words[at] + "'" + list);
  }
  throw InputError(where + ": unknown keyword '" + words[at] + "'" +
                   did_you_mean(words[at], known) + list);
}

/// True for a keyword, and, where a group may end, for what looks like a mistyped one.
bool ends_group(const ArgTable& table, const std::string& word, bool may_end) {
  if (table.find(word) != nullptr) return true;
  return may_end && !looks_like_a_number(word) && !closest_word(word, table.names()).empty();
}

/// The words of a group that starts at `begin`: up to words_max, ending before any keyword.
std::vector<std::string> take_group(const ArgTable& table, const Keyword& keyword,
                                    const std::string& where, const std::vector<std::string>& words,
                                    std::size_t begin) {
  std::vector<std::string> group;
  for (std::size_t at = begin; at < words.size() && group.size() < keyword.words_max; ++at) {
    if (ends_group(table, words[at], group.size() >= keyword.words_min)) break;
    group.push_back(words[at]);
  }
  if (group.size() >= keyword.words_min) return group;
  const std::string at_least = keyword.words_min == keyword.words_max ? "" : "at least ";
  throw InputError(where + ": " + keyword.name + " needs " + at_least +
                   std::to_string(keyword.words_min) + " words (" + keyword.text + "), got '" +
                   joined(group, " ") + "'");
}

/// Of a second keyword at `at`, beside the `first` value. A script may take words from a variable,
/// and whoever sets that does not see the other ones.
std::string twice(const Keyword& keyword, const std::string& first,
                  const std::vector<std::string>& words, std::size_t at) {
  const bool of_one_value = keyword.kind != Keyword::Kind::group && at + 1 < words.size();
  const std::string values =
      " as '" + first + "' and as '" + (of_one_value ? words[at + 1] : "") + "'";
  return keyword.name + " is given twice" + (of_one_value ? "," + values : "") +
         "; words that a variable adds to a command replace none of those that it has";
}

const char* kind_text(Keyword::Kind kind) {
  switch (kind) {
    case Keyword::Kind::real:
      return "real";
    case Keyword::Kind::integer:
      return "integer";
    case Keyword::Kind::word:
      return "word";
    case Keyword::Kind::flag:
      return "flag";
    case Keyword::Kind::group:
      return "group";
  }
  return "?";
}

}  // namespace

ArgValues::ArgValues(std::string where, const ArgTable& table)
    : where_(std::move(where)), order_(table.names()) {
  for (const Keyword& keyword : table.keywords()) {
    Entry& entry = entries_[keyword.name];
    entry.keyword = keyword;
    if (keyword.fallback) store(entry, *keyword.fallback);
  }
}

void ArgValues::store(Entry& entry, const std::string& text) const {
  const Keyword& keyword = entry.keyword;
  if (keyword.kind == Keyword::Kind::real)
    entry.real = parse_real(where_, keyword.name, text, keyword.unit, keyword.range);
  if (keyword.kind == Keyword::Kind::integer)
    entry.integer = parse_integer(where_, keyword.name, text, keyword.unit, keyword.range);
  const std::vector<std::string>& choices = keyword.choices;
  if (!choices.empty() && std::find(choices.begin(), choices.end(), text) == choices.end())
    throw InputError(where_ + ": " + keyword.name + " must be one of " + joined(choices) +
                     ", got '" + text + "'" + did_you_mean(text, choices));
  entry.word = text;
}

ArgValues parse_args(const ArgTable& table, const std::string& where,
                     const std::vector<std::string>& words) {
  ArgValues values(where, table);
  std::size_t at = 0;
  while (at < words.size()) {
    const Keyword* const keyword = table.find(words[at]);
    if (keyword == nullptr) refuse_unknown(table, where, words, at);
    ArgValues::Entry& entry = values.entries_.at(keyword->name);
    if (entry.given && !keyword->repeatable)
      throw InputError(where + ": " + twice(*keyword, entry.word, words, at));
    entry.given = true;
    ++at;
    if (keyword->kind == Keyword::Kind::group) {
      entry.groups.push_back(take_group(table, *keyword, where, words, at));
      at += entry.groups.back().size();
      continue;
    }
    if (at == words.size())
      throw InputError(where + ": " + keyword->name + " has no value after it (" + keyword->text +
                       (keyword->unit.empty() ? "" : ", in " + keyword->unit) + ")");
    values.store(entry, words[at]);
    ++at;
  }
  for (const Keyword& keyword : table.keywords()) {
    const bool optional = keyword.fallback.has_value() || keyword.kind == Keyword::Kind::group;
    if (optional || values.given(keyword.name)) continue;
    throw InputError(where + ": keyword " + keyword.name + " is missing (" + keyword.text +
                     (keyword.unit.empty() ? "" : ", in " + keyword.unit) + ")");
  }
  return values;
}

const ArgValues::Entry& ArgValues::entry(const std::string& name, Keyword::Kind kind) const {
  const auto found = entries_.find(name);
  if (found == entries_.end() || found->second.keyword.kind != kind)
    throw std::logic_error(where_ + ": the table has no " + kind_text(kind) + " keyword " + name);
  return found->second;
}

double ArgValues::real(const std::string& name) const {
  return entry(name, Keyword::Kind::real).real;
}

long ArgValues::integer(const std::string& name) const {
  return entry(name, Keyword::Kind::integer).integer;
}

const std::string& ArgValues::word(const std::string& name) const {
  return entry(name, Keyword::Kind::word).word;
}

bool ArgValues::flag(const std::string& name) const {
  return entry(name, Keyword::Kind::flag).word == "yes";
}

bool ArgValues::given(const std::string& name) const {
  const auto found = entries_.find(name);
  if (found == entries_.end())
    throw std::logic_error(where_ + ": the table has no keyword " + name);
  return found->second.given;
}

const std::vector<std::vector<std::string>>& ArgValues::groups(const std::string& name) const {
  return entry(name, Keyword::Kind::group).groups;
}

std::string ArgValues::echo() const {
  std::string result = where_ + ":\n";
  for (const std::string& name : order_) {
    const Entry& entry = entries_.at(name);
    if (entry.keyword.kind == Keyword::Kind::group) {
      for (const std::vector<std::string>& group : entry.groups)
        result += "  " + name + " " + joined(group, " ") + "\n";
      continue;
    }
    result += "  " + name + " " + entry.word;
    if (!entry.keyword.unit.empty()) result += " " + entry.keyword.unit;
    result += entry.given ? "\n" : " (default)\n";
  }
  return result;
}

}  // namespace muckpile
