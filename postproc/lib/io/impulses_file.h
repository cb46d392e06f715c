// SPDX-License-Identifier: GPL-2.0-or-later
// What fix muckpile/dump wrote for fix muckpile/impulse: what has pushed each block up to a
// snapshot. Scope: docs/styles/fix_muckpile_impulse.md has the columns.
#pragma once

#include <filesystem>
#include <vector>

#include "io/blocks_file.h"
#include "motion/impulse_sums.h"

namespace muckpile {

// Impulses [N s] on the blocks of the model, in the order of `blocks`, which may have images behind
// them. Throws InputError, naming file and line, if the file is absent or damaged, of another run
// than `run_id` ("": any), or a block has no row, or two.
std::vector<ByPart> read_impulses(const std::filesystem::path& path,
                                  const std::vector<StartBlock>& blocks, const std::string& run_id);

}  // namespace muckpile
