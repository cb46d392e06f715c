// SPDX-License-Identifier: GPL-2.0-or-later
// Which blocks the blast broke out of the rock: the pile, as against the rock that stayed.
// Scope: by displacement of the block's centroid alone, so it needs no view of the joints.
#pragma once

#include <vector>

#include "io/blocks_file.h"
#include "io/snapshot.h"

namespace muckpile {

// 1 for a block whose centroid has moved by more than its own size and by more than `least_move`
// [m]: it has left its own place, which elastic rebound and heave do not do.
std::vector<char> broken_out(const std::vector<StartBlock>& blocks,
                             const std::vector<BlockState>& states, double least_move);

// 1 for a block faster than 1 m/s: it flies or rolls, and is no part of any surface yet.
std::vector<char> on_the_move(const std::vector<BlockState>& states);

// (mean volume)^(1/3) [m] of the chosen blocks; 0 if there is none.
double mean_block_size(const std::vector<StartBlock>& blocks, const std::vector<char>& chosen);

}  // namespace muckpile
