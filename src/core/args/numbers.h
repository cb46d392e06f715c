// SPDX-License-Identifier: GPL-2.0-or-later
// Strict reading of one number from one word of an input script, and the shortest exact text back.
// Scope: the whole word must be the number; NaN, infinity, hexadecimal and locale forms are
// refused.
#pragma once

#include <string>

#include "args/range.h"

namespace muckpile {

/// Reads a real number [unit]. `where` names the style and id for the message, e.g.
/// "fix muckpile/blast 'gas1'"; `unit` is "" for a pure number.
/// Throws InputError: not a number, not finite, or outside `range`.
[[nodiscard]] double parse_real(const std::string& where, const std::string& keyword,
                                const std::string& text, const std::string& unit, Range range);

/// Reads a whole number; "3.0" and "1e3" are refused. Throws InputError like parse_real.
[[nodiscard]] long parse_integer(const std::string& where, const std::string& keyword,
                                 const std::string& text, const std::string& unit, Range range);

/// Shortest text that reads back to the same double.
[[nodiscard]] std::string number_text(double value);

}  // namespace muckpile
