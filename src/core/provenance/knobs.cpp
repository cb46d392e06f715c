// SPDX-License-Identifier: GPL-2.0-or-later
// Knobs of two runs side by side.
// Scope: see the header.
#include "provenance/knobs.h"

#include <algorithm>
#include <map>

#include "args/input_error.h"
#include "args/numbers.h"

namespace muckpile {
namespace {

using Values = std::map<std::string, std::optional<std::string>>;

Values by_name(const Knobs& knobs, const std::vector<std::string>& free) {
  Values values;
  for (const Knob& knob : knobs) {
    if (std::find(free.begin(), free.end(), knob.name) == free.end())
      values[knob.name] = knob.value;
  }
  return values;
}

bool same(const std::optional<std::string>& a, const std::optional<std::string>& b) {
  return a && b ? same_value(*a, *b) : !a && !b;
}

std::vector<std::string> knobs_only_in(const Values& here, const Values& there) {
  std::vector<std::string> names;
  for (const auto& [name, value] : here) {
    if (value && there.count(name) == 0) names.push_back(name);
  }
  return names;
}

double as_number(const Spelt& spelt) {
  const long* whole = std::get_if<long>(&spelt);
  return whole != nullptr ? static_cast<double>(*whole) : std::get<double>(spelt);
}

}  // namespace

Spelt read_spelling(const std::string& text) {
  try {
    return parse_integer("", "", text, "", Range::any());
  } catch (const InputError&) {
  }
  try {
    return parse_real("", "", text, "", Range::any());
  } catch (const InputError&) {
    return text;
  }
}

bool same_value(const std::string& a, const std::string& b) {
  if (a == b) return true;
  const Spelt first = read_spelling(a), second = read_spelling(b);
  if (std::holds_alternative<std::string>(first) || std::holds_alternative<std::string>(second))
    return false;
  return as_number(first) == as_number(second);
}

KnobChanges knob_changes(const Knobs& before, const Knobs& now,
                         const std::vector<std::string>& free) {
  const Values then = by_name(before, free), present = by_name(now, free);
  KnobChanges changes;
  for (const auto& [name, value] : present) {
    const auto found = then.find(name);
    if (found != then.end() && !same(found->second, value))
      changes.other.push_back({name, found->second, value});
  }
  changes.missing = knobs_only_in(then, present);
  changes.added = knobs_only_in(present, then);
  return changes;
}

std::string describe(const std::vector<KnobChange>& changes) {
  std::string text;
  for (const KnobChange& change : changes) {
    if (!text.empty()) text += ", ";
    text += change.name + ' ' + (change.now ? '\'' + *change.now + '\'' : "computed") + " (was " +
            (change.before ? '\'' + *change.before + '\'' : "computed") + ')';
  }
  return text;
}

}  // namespace muckpile
