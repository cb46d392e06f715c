// SPDX-License-Identifier: GPL-2.0-or-later
// Mistyped names behind -var: LIGGGHTS takes any, and the script's own default then stands. Of two
// values it takes the first.
// Scope: variables that a script and the files it includes set or read; says nothing where a file
// cannot be found.
#pragma once

#include <string>
#include <vector>

namespace muckpile {

/// One line for each name behind -var that is there twice, and for each that is no variable of the
/// script behind -in.
[[nodiscard]] std::vector<std::string> unused_variables(const std::vector<std::string>& arguments);

}  // namespace muckpile
