// SPDX-License-Identifier: GPL-2.0-or-later
// The knobs of an input script, its variables with a value that -var can set, and what differs
// between those of two runs.
// Scope: names and texts; two spellings of one number are the same value.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "state/encoding.h"

namespace muckpile {

/// A variable of a script. Without a value the script computes it: it is no knob there, but may be
/// one in another run, such as a friction that a script works out when it is given as -1.
struct Knob {
  std::string name;
  std::optional<std::string> value;
};
template <>
struct Stored<Knob> {
  static constexpr std::string_view kName = "knob";
  static constexpr int kVersion = 1;
  static auto fields(auto& knob) { return std::tie(knob.name, knob.value); }
};
using Knobs = std::vector<Knob>;  ///< each name once

/// Equal texts, or numbers of equal value: 3, 3.0 and +3e0.
[[nodiscard]] bool same_value(const std::string& a, const std::string& b);

/// A text as what it spells: a whole number, another finite number, or a word.
using Spelt = std::variant<long, double, std::string>;
[[nodiscard]] Spelt read_spelling(const std::string& text);

struct KnobChange {
  std::string name;
  std::optional<std::string> before, now;  ///< nothing: the script computes it
};

struct KnobChanges {
  std::vector<KnobChange> other;     ///< a value on one side at least, and not the same
  std::vector<std::string> missing;  ///< knobs of before that the script now has not at all
  std::vector<std::string> added;    ///< knobs of now that the script before had not at all
};

/// Knobs whose names are in `free` are left out.
[[nodiscard]] KnobChanges knob_changes(const Knobs& before, const Knobs& now,
                                       const std::vector<std::string>& free);

/// "burden '3' (was '1.8'), friction '0.5' (was computed)".
[[nodiscard]] std::string describe(const std::vector<KnobChange>& changes);

}  // namespace muckpile
