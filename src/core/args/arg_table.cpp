// SPDX-License-Identifier: GPL-2.0-or-later
// The keyword table of one style: the single source of its parser, its messages and its docs table.
// Scope: see arg_table.h.
#include "args/arg_table.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "args/numbers.h"
#include "args/suggestion.h"

namespace muckpile {
namespace {

/// "1 to 5" where both ends belong to it.
std::string interval(const Range& range) {
  const bool closed =
      std::isfinite(range.lo) && std::isfinite(range.hi) && !range.lo_open && !range.hi_open;
  return closed ? number_text(range.lo) + " to " + number_text(range.hi) : range.text();
}

std::string range_cell(const Keyword& keyword) {
  using Kind = Keyword::Kind;
  switch (keyword.kind) {
    case Kind::real:
      return keyword.range.text().empty() ? "any" : interval(keyword.range);
    case Kind::integer:
      return keyword.range.text().empty() ? "whole" : "whole, " + interval(keyword.range);
    case Kind::word:
      return keyword.choices.empty() ? "one word" : joined(keyword.choices);
    case Kind::flag:
      return joined(keyword.choices);
    case Kind::group:
      break;
  }
  std::string count = std::to_string(keyword.words_min);
  if (keyword.words_max != keyword.words_min) count += " to " + std::to_string(keyword.words_max);
  return count + (keyword.words_max == 1 ? " word" : " words") +
         (keyword.repeatable ? ", repeatable" : "");
}

std::string default_cell(const Keyword& keyword) {
  if (keyword.kind == Keyword::Kind::group) return "none";
  return keyword.fallback.value_or("required");
}

}  // namespace

ArgTable::ArgTable(std::string style) : style_(std::move(style)) {}

ArgTable& ArgTable::real(const std::string& name, const std::string& unit, Range range,
                         std::optional<double> fallback, const std::string& text) {
  Keyword keyword{.name = name, .kind = Keyword::Kind::real, .unit = unit, .range = range};
  if (fallback && !range.contains(*fallback))
    throw std::logic_error(style_ + ": the default of " + name + " breaks its own range");
  if (fallback) keyword.fallback = number_text(*fallback);
  keyword.text = text;
  return add(std::move(keyword));
}

ArgTable& ArgTable::integer(const std::string& name, const std::string& unit, Range range,
                            std::optional<long> fallback, const std::string& text) {
  Keyword keyword{.name = name, .kind = Keyword::Kind::integer, .unit = unit, .range = range};
  if (fallback && !range.contains(static_cast<double>(*fallback)))
    throw std::logic_error(style_ + ": the default of " + name + " breaks its own range");
  if (fallback) keyword.fallback = std::to_string(*fallback);
  keyword.text = text;
  return add(std::move(keyword));
}

ArgTable& ArgTable::word(const std::string& name, const std::vector<std::string>& choices,
                         const std::optional<std::string>& fallback, const std::string& text) {
  const bool free_choice = choices.empty() || !fallback;
  if (!free_choice && std::find(choices.begin(), choices.end(), *fallback) == choices.end())
    throw std::logic_error(style_ + ": the default of " + name + " is not among its choices");
  return add({.name = name, .choices = choices, .fallback = fallback, .text = text});
}

ArgTable& ArgTable::flag(const std::string& name, bool fallback, const std::string& text) {
  return add({.name = name,
              .kind = Keyword::Kind::flag,
              .choices = {"yes", "no"},
              .fallback = fallback ? "yes" : "no",
              .text = text});
}

ArgTable& ArgTable::group(const std::string& name, std::size_t words_min, std::size_t words_max,
                          bool repeatable, const std::string& text) {
  if (words_min > words_max || words_max == 0)
    throw std::logic_error(style_ + ": " + name + " takes no words");
  return add({.name = name,
              .kind = Keyword::Kind::group,
              .words_min = words_min,
              .words_max = words_max,
              .repeatable = repeatable,
              .text = text});
}

std::vector<std::string> ArgTable::names() const {
  std::vector<std::string> result;
  for (const Keyword& keyword : keywords_) result.push_back(keyword.name);
  return result;
}

const Keyword* ArgTable::find(const std::string& name) const {
  const auto row = std::find_if(keywords_.begin(), keywords_.end(),
                                [&name](const Keyword& keyword) { return keyword.name == name; });
  return row == keywords_.end() ? nullptr : &*row;
}

std::string ArgTable::markdown() const {
  std::string result = "| keyword | unit | range | default | meaning |\n|---|---|---|---|---|\n";
  for (const Keyword& keyword : keywords_)
    result += "| `" + keyword.name + "` | " + (keyword.unit.empty() ? "-" : keyword.unit) + " | " +
              range_cell(keyword) + " | " + default_cell(keyword) + " | " + keyword.text + " |\n";
  return result;
}

ArgTable& ArgTable::add(Keyword keyword) {
  if (find(keyword.name) != nullptr)
    throw std::logic_error(style_ + ": keyword " + keyword.name + " is in the table twice");
  keywords_.push_back(std::move(keyword));
  return *this;
}

}  // namespace muckpile
