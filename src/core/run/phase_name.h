// SPDX-License-Identifier: GPL-2.0-or-later
// The name of a phase, which stands in history.csv as it was typed.
// Scope: refuses what would split or quote a cell of that file.
#pragma once

#include <string>

#include "args/input_error.h"

namespace muckpile {

inline std::string phase_name(const std::string& where, const std::string& key,
                              const std::string& typed) {
  if (typed.find_first_of(",\"'") == std::string::npos) return typed;
  refuse(where, key + " must be without commas and quotes, got '" + typed + "'");
}

}  // namespace muckpile
