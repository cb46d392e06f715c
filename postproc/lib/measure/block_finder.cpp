// SPDX-License-Identifier: GPL-2.0-or-later
// Which block a point lay in before the blast.
// Scope: see the header.
#include "measure/block_finder.h"

#include <algorithm>
#include <cmath>

namespace muckpile {
namespace {

constexpr double kOutside = 1e-9;  // of its size, that a point may be off a block

double mean_size(const std::vector<StartBlock>& blocks) {
  double sum = 0.0;
  for (const StartBlock& block : blocks) sum += block.size;
  return sum / static_cast<double>(blocks.size());
}

}  // namespace

bool lies_within(const StartBlock& block, const Vec3& place, double depth) {
  constexpr double kSliver = 1e-12;  // area of a face without one, of the block's size squared
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

BlockFinder::BlockFinder(const std::vector<StartBlock>& blocks)
    : blocks_(blocks), width_(mean_size(blocks)) {
  for (size_t b = 0; b < blocks.size(); ++b) {
    Vec3 low = blocks[b].shape.vertices.front(), high = low;
    for (const Vec3& v : blocks[b].shape.vertices) low = low.cwiseMin(v), high = high.cwiseMax(v);
    const Cell from = cell_of(low), to = cell_of(high);
    for (long i = from[0]; i <= to[0]; ++i)
      for (long j = from[1]; j <= to[1]; ++j)
        for (long k = from[2]; k <= to[2]; ++k) in_cell_[{i, j, k}].push_back(b);
  }
}

BlockFinder::Cell BlockFinder::cell_of(const Vec3& point) const {
  const auto along = [&](double c) { return std::lround(std::floor(c / width_)); };
  return {along(point.x()), along(point.y()), along(point.z())};
}

std::optional<size_t> BlockFinder::at(const Vec3& point) const {
  const auto cell = in_cell_.find(cell_of(point));
  if (cell == in_cell_.end()) return std::nullopt;
  for (const size_t b : cell->second)
    if (lies_within(blocks_[b], point, -kOutside * blocks_[b].size)) return b;
  return std::nullopt;
}

}  // namespace muckpile
