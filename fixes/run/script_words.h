// SPDX-License-Identifier: GPL-2.0-or-later
// Commands as a script gives them.
// Scope: of the program's own commands, such as run_blast. Collective.
#pragma once

#include <fix.h>
#include <input.h>
#include <lammps.h>
#include <modify.h>

#include <cstdio>
#include <string>

namespace muckpile {

/// As long as a number of LIGGGHTS' own variables.
inline std::string script_number(double value) {
  char digits[32];
  std::snprintf(digits, sizeof digits, "%.15g", value);
  return digits;
}

inline void tell_script(LAMMPS_NS::LAMMPS& lmp, const std::string& line) {
  lmp.input->one(line.c_str());
}

/// Null: the script has none of this style.
inline LAMMPS_NS::Fix* fix_of(LAMMPS_NS::LAMMPS& lmp, const std::string& style) {
  return lmp.modify->find_fix_style_strict(style.c_str(), 0);
}

/// Makes it where there is none of this style. True: it is new.
inline bool make_fix(LAMMPS_NS::LAMMPS& lmp, const std::string& style, const std::string& id,
                     const std::string& words) {
  if (fix_of(lmp, style) != nullptr) return false;
  tell_script(lmp, "fix " + id + " all " + style + " " + words);
  return true;
}

}  // namespace muckpile
