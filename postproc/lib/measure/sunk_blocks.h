// SPDX-License-Identifier: GPL-2.0-or-later
// Blocks that lie in others: contact by spheres leaves gaps, in which small blocks can come to lie.
// Scope: convex blocks in one snapshot.
#pragma once

#include <vector>

#include "io/snapshot.h"

namespace muckpile {

// Per block: 1 where its centre lies in another block, deeper than a thousandth of its own size.
std::vector<char> sunk_blocks(const std::vector<StartBlock>& blocks,
                              const std::vector<BlockState>& states);

}  // namespace muckpile
