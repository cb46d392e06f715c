// SPDX-License-Identifier: GPL-2.0-or-later
// The whole blast from a model of its half or quarter.
// Scope: see the header.
#include "io/images.h"

#include <algorithm>

namespace muckpile {
namespace {

constexpr int kInX = 1, kInY = 2;  // bits of StartBlock::image

Vec3 signs_of(int image) {
  return {(image & kInX) != 0 ? -1.0 : 1.0, (image & kInY) != 0 ? -1.0 : 1.0, 1.0};
}

StartBlock image_of(StartBlock block, int image, int id) {
  const Vec3 signs = signs_of(image);
  Polyhedron shape = polyhedron_of(block.shape);
  for (Vec3& vertex : shape.vertices) vertex = vertex.cwiseProduct(signs);
  if (signs.prod() < 0.0) {
    for (std::vector<int>& face : shape.faces) std::ranges::reverse(face);
  }
  block.shape = shape;
  block.centroid = block.centroid.cwiseProduct(signs);
  block.id = id;
  block.image = image;
  return block;
}

// A turn is a pseudovector: one reflection reverses what of it lies in the plane.
BlockState image_of(const BlockState& state, int image, int first_id) {
  const Vec3 signs = signs_of(image), turns = signs.prod() * signs;
  const Vec3 axis = state.rotation.vec().cwiseProduct(turns);
  return {
      state.centre.cwiseProduct(signs),   Quat(state.rotation.w(), axis.x(), axis.y(), axis.z()),
      state.velocity.cwiseProduct(signs), state.spin.cwiseProduct(turns),
      state.fragment + first_id,          state.broken_fraction};
}

}  // namespace

void add_images(std::vector<StartBlock>& blocks, int symmetry) {
  const size_t count = blocks.size();
  if (count == 0) return;
  const int ids = blocks.back().id;
  int first_id = 0;
  for (const int image : {kInY, kInX, kInX | kInY}) {
    if (symmetry == 1 || (symmetry == 2 && image != kInY)) continue;
    first_id += ids;
    for (size_t b = 0; b < count; ++b)
      blocks.push_back(image_of(blocks[b], image, blocks[b].id + first_id));
  }
}

size_t modelled(const std::vector<StartBlock>& blocks) {
  if (blocks.empty() || blocks.back().image <= 0) return blocks.size();  // images stand behind
  const auto images = std::ranges::find_if(blocks, [](const StartBlock& b) { return b.image > 0; });
  return static_cast<size_t>(images - blocks.begin());
}

void add_image_states(const std::vector<StartBlock>& blocks, std::vector<BlockState>& states) {
  const size_t count = modelled(blocks);
  for (size_t b = count; b < blocks.size(); ++b) {
    const StartBlock& original = blocks[b % count];
    states[b] = image_of(states[b % count], blocks[b].image, blocks[b].id - original.id);
  }
}

}  // namespace muckpile
