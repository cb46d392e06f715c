// SPDX-License-Identifier: GPL-2.0-or-later
// Mistyped names behind -var, and in the files of a user's own that it names, such as a rock's:
// LIGGGHTS takes any, and the script's own default then stands. Of two values it takes the first.
// Scope: variables that a script and the files it includes set or read; says nothing where a file
// cannot be found.
#pragma once

#include <string>
#include <vector>

namespace muckpile {

/// One line for each name behind -var that is there twice, for each that is no variable of the
/// script behind -in, and for each variable that a file which is included by such a value sets
/// twice or that nothing reads.
[[nodiscard]] std::vector<std::string> unused_variables(const std::vector<std::string>& arguments);

}  // namespace muckpile
