// SPDX-License-Identifier: GPL-2.0-or-later
// The keyword tables of all styles that read `keyword value` pairs, for the pages in docs/styles.
// Scope: a list; each table is beside the style that parses by it.
#pragma once

#include <vector>

#include "args/arg_table.h"

namespace muckpile {

[[nodiscard]] const ArgTable& block_contact_keywords();
[[nodiscard]] const ArgTable& block_motion_keywords();
[[nodiscard]] const ArgTable& dump_keywords();
[[nodiscard]] const ArgTable& gas_keywords();
[[nodiscard]] const ArgTable& gauges_keywords();
[[nodiscard]] const ArgTable& joint_keywords();
[[nodiscard]] const ArgTable& progress_keywords();
[[nodiscard]] const ArgTable& quiet_keywords();
[[nodiscard]] const ArgTable& rank_grid_keywords();
[[nodiscard]] const ArgTable& sleep_keywords();
[[nodiscard]] const ArgTable& timestep_keywords();

/// One table per style. A page shows each between `<!-- arguments of STYLE -->` and
/// `<!-- end of arguments -->`, STYLE as the table has it.
[[nodiscard]] std::vector<ArgTable> keyword_tables();

}  // namespace muckpile
