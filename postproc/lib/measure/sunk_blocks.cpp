// SPDX-License-Identifier: GPL-2.0-or-later
// Blocks that lie in others: a tree of the balls around them, then their faces.
// Scope: see the header.
#include "measure/sunk_blocks.h"

#include <algorithm>
#include <span>

#include "geometry/index/box_tree.h"

namespace muckpile {
namespace {

constexpr double kSliver =
    1e-12;  // area of a face that bounds nothing, of the block's size squared

// `place` as the block stood at the start.
bool holds(const StartBlock& block, const Vec3& place, double depth) {
  return std::ranges::all_of(block.shape.faces, [&](std::span<const int> face) {
    const auto vertex = [&](size_t k) -> const Vec3& {
      return block.shape.vertices[static_cast<size_t>(face[k])];
    };
    Vec3 normal = Vec3::Zero();  // by all corners, as three of them may lie on a line (Newell)
    for (size_t k = 0; k < face.size(); ++k)
      normal += (vertex(k) - vertex(0)).cross(vertex((k + 1) % face.size()) - vertex(0));
    const bool sliver = normal.norm() <= kSliver * block.size * block.size;
    return sliver || normal.dot(place - vertex(0)) < -depth * normal.norm();
  });
}

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
      return other != b && holds(blocks[other],
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
