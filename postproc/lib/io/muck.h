// SPDX-License-Identifier: GPL-2.0-or-later
// The rock that is blasted, apart from muck that lay in front of it (create_blocks ... muck).
// Scope: muck follows the rock in every list of blocks; a model with images has none.
#pragma once

#include <vector>

#include "io/snapshot.h"

namespace muckpile {

// StartBlock::image of muck.
inline constexpr int kMuckImage = -1;
inline bool is_muck(const StartBlock& block) { return block.image == kMuckImage; }

// How many of the blocks are rock.
size_t rock_blocks(const std::vector<StartBlock>& blocks);

// Splits the muck off: what it returns.
std::vector<StartBlock> split_muck(std::vector<StartBlock>& blocks);
std::vector<BlockState> split_muck(std::vector<BlockState>& states, size_t rock);

}  // namespace muckpile
