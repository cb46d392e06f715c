// SPDX-License-Identifier: GPL-2.0-or-later
// Which blocks the blast broke out of the rock: the pile, as against the rock that stayed.
// Scope: by displacement of the block's centroid alone, so it needs no view of the joints.
#include "measure/broken_out.h"

#include <algorithm>
#include <cmath>

namespace muckpile {

std::vector<char> broken_out(const std::vector<StartBlock>& blocks,
                             const std::vector<BlockState>& states, double least_move) {
  std::vector<char> moved(blocks.size());
  for (size_t b = 0; b < blocks.size(); ++b) {
    moved[b] =
        (states[b].centre - blocks[b].centroid).norm() > std::max(least_move, blocks[b].size);
  }
  return moved;
}

std::vector<char> on_the_move(const std::vector<BlockState>& states) {
  constexpr double kFast = 1.0;  // [m/s]; a block that falls has this speed after 5 cm
  std::vector<char> moves;
  for (const BlockState& state : states) moves.push_back(state.velocity.norm() > kFast ? 1 : 0);
  return moves;
}

double mean_block_size(const std::vector<StartBlock>& blocks, const std::vector<char>& chosen) {
  double volume = 0.0, count = 0.0;
  for (size_t b = 0; b < blocks.size(); ++b) {
    if (chosen[b] == 0) continue;
    volume += blocks[b].volume;
    count += 1.0;
  }
  return count > 0.0 ? std::cbrt(volume / count) : 0.0;
}

}  // namespace muckpile
