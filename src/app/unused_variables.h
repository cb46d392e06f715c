// SPDX-License-Identifier: GPL-2.0-or-later
// Mistyped names behind -var: LIGGGHTS takes any, and the script's own default then stands.
// Scope: what the text of a script and of the files it includes mentions; says nothing where a file
// cannot be found.
#pragma once

#include <string>
#include <vector>

namespace muckpile {

/// One line for each name behind -var that the script behind -in mentions nowhere.
[[nodiscard]] std::vector<std::string> unused_variables(const std::vector<std::string>& arguments);

}  // namespace muckpile
