// SPDX-License-Identifier: GPL-2.0-or-later
// The rock that is blasted, apart from muck in front of it.
// Scope: see the header.
#include "io/muck.h"

#include <algorithm>
#include <iterator>

namespace muckpile {
namespace {

template <class Item>
std::vector<Item> split(std::vector<Item>& all, size_t first) {
  const auto from = all.begin() + static_cast<std::ptrdiff_t>(first);
  std::vector<Item> rest(std::make_move_iterator(from), std::make_move_iterator(all.end()));
  all.erase(from, all.end());
  return rest;
}

}  // namespace

size_t rock_blocks(const std::vector<StartBlock>& blocks) {
  return static_cast<size_t>(std::ranges::find_if(blocks, is_muck) - blocks.begin());
}

std::vector<StartBlock> split_muck(std::vector<StartBlock>& blocks) {
  return split(blocks, rock_blocks(blocks));
}

std::vector<BlockState> split_muck(std::vector<BlockState>& states, size_t rock) {
  return split(states, std::min(rock, states.size()));
}

}  // namespace muckpile
