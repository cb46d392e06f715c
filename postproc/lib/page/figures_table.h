// SPDX-License-Identifier: GPL-2.0-or-later
// Figures of summary.json and scene.json in words: a name, a rounded value and its unit.
// Scope: units stand at the end of the keys, as everywhere in Muckpile.
#pragma once

#include <string>
#include <vector>

#include "figures/figures.h"

namespace muckpile {

struct KeyAndUnit {
  std::string name;  // the key without its unit, underscores as blanks
  std::string unit;  // "" where the key has none
};

KeyAndUnit split_unit(const std::string& key);

// Three digits, whole numbers in full, thousands apart.
std::string rounded(double value);

// The value with its unit; joules and pascals in the unit of a thousand fitting steps; "none" for
// null, "yes" and "no", text as it is.
std::string in_words(const std::string& key, const check::Json& value);

// What an engineer looks for first, by the words of the field.
struct NamedKey {
  const char *key, *name;
};
const std::vector<NamedKey>& key_figures();

}  // namespace muckpile
