// SPDX-License-Identifier: GPL-2.0-or-later
// The keywords of create_blocks.
// Scope: names, units, ranges and texts; what they mean together is in cut_options.h.
#pragma once

#include <string>

#include "args/arg_table.h"

namespace muckpile {

inline constexpr const char* kCreateBlocks = "create_blocks";  ///< starts every message

[[nodiscard]] const ArgTable& cut_table();

/// What geometry and tables say, after the name of the style.
[[nodiscard]] std::string in_create_blocks(const std::string& message);

}  // namespace muckpile
