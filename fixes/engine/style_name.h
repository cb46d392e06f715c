// SPDX-License-Identifier: GPL-2.0-or-later
// How messages name a fix: its style, and the ID that the script gave it.
// Scope: text.
#pragma once

#include <fix.h>

#include <string>

namespace muckpile::engine {

/// "fix STYLE 'ID'"; `arg`: the words of the fix command from its ID on, three at least.
[[nodiscard]] inline std::string name_of_fix(char** arg) {
  return std::string("fix ") + arg[2] + " '" + arg[0] + "'";
}
[[nodiscard]] inline std::string name_of(const LAMMPS_NS::Fix& fix) {
  return std::string("fix ") + fix.style + " '" + fix.id + "'";
}
/// How messages name a fix_modify of the fix.
[[nodiscard]] inline std::string name_of_modify(const LAMMPS_NS::Fix& fix) {
  return std::string("fix_modify ") + fix.id;
}

}  // namespace muckpile::engine
