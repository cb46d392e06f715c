// SPDX-License-Identifier: GPL-2.0-or-later
// The keywords of create_blocks.
// Scope: names, units, ranges and texts; what they mean together is in cut_options.h.
#pragma once

#include <string>

#include "args/arg_table.h"
#include "args/range.h"

namespace muckpile {

inline constexpr const char* kCreateBlocks = "create_blocks";  ///< starts every message

[[nodiscard]] const ArgTable& cut_table();

/// One word of a keyword as a number [unit]. Throws InputError like parse_real().
[[nodiscard]] double cut_real(const std::string& keyword, const std::string& word, const char* unit,
                              const Range& range);
/// As a whole number.
[[nodiscard]] long cut_whole(const std::string& keyword, const std::string& word,
                             const Range& range);
/// An angle in degrees, 0 to `most_degrees`, in radians.
[[nodiscard]] double cut_radians(const std::string& keyword, const std::string& word,
                                 double most_degrees);

/// What geometry and tables say, after the name of the style.
[[nodiscard]] std::string in_create_blocks(const std::string& message);

}  // namespace muckpile
