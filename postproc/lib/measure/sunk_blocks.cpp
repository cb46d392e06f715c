// SPDX-License-Identifier: GPL-2.0-or-later
// Blocks that lie in others: a tree of the balls around them, then their faces.
// Scope: see the header.
#include "measure/sunk_blocks.h"

#include <algorithm>

#include "geometry/index/box_tree.h"
#include "measure/block_finder.h"

namespace muckpile {
namespace {

std::vector<BoxTree::Item> boxes_around(const std::vector<StartBlock>& blocks,
                                        const std::vector<BlockState>& states) {
  std::vector<BoxTree::Item> boxes;
  boxes.reserve(blocks.size());
  for (size_t b = 0; b < blocks.size(); ++b) {
    double reach = 0.0;
    for (const Vec3& v : blocks[b].shape.vertices)
      reach = std::max(reach, (v - blocks[b].centroid).norm());
    const Vec3& centre = states[b].centre;
    boxes.push_back({centre - Vec3::Constant(reach), centre + Vec3::Constant(reach), centre});
  }
  return boxes;
}

}  // namespace

std::vector<char> sunk_blocks(const std::vector<StartBlock>& blocks,
                              const std::vector<BlockState>& states) {
  constexpr int kInALeaf = 8;
  constexpr double kDeep = 1e-3;  // of the block's size
  const BoxTree tree(boxes_around(blocks, states), kInALeaf);
  std::vector<char> sunk(blocks.size(), 0);
  for (size_t b = 0; b < blocks.size(); ++b) {
    const Vec3& centre = states[b].centre;
    const auto holds_it = [&](size_t other) {
      const Vec3 from = centre - states[other].centre;
      return other != b &&
             lies_within(blocks[other],
                         blocks[other].centroid + states[other].rotation.conjugate() * from,
                         kDeep * blocks[b].size);
    };
    if (tree.any([&](const BoxTree::Node& node) { return node.distance2(centre) <= 0.0; },
                 holds_it))
      sunk[b] = 1;
  }
  return sunk;
}

}  // namespace muckpile
