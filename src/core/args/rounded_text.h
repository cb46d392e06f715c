// SPDX-License-Identifier: GPL-2.0-or-later
// A number as a reader wants it.
// Scope: six digits unless told otherwise, for lines on the screen and messages; exact text is
// number_text() of args/numbers.h.
#pragma once

#include <string>

namespace muckpile {

[[nodiscard]] std::string rounded_text(double value, int digits = 6);

}  // namespace muckpile
