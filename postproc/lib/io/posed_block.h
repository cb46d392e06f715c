// SPDX-License-Identifier: GPL-2.0-or-later
// Blocks in a pose, for loops over all of them.
// Scope: rigid motion only.
#pragma once

#include <vector>

#include "io/snapshot.h"

namespace muckpile {

// What moved_vertices(block, state) gives, into `moved`, whose memory is used again.
inline void move_vertices(const StartBlock& block, const BlockState& state,
                          std::vector<Vec3>& moved) {
  const Mat3 turn = state.rotation.toRotationMatrix();
  moved.clear();
  moved.reserve(block.shape.vertices.size());
  for (const Vec3& p : block.shape.vertices)
    moved.push_back(state.centre + turn * (p - block.centroid));
}

// A block at rest where it started.
inline BlockState start_state(const StartBlock& block) {
  return {block.centroid, Quat::Identity(), Vec3::Zero(), Vec3::Zero(), block.id, 0.0};
}

}  // namespace muckpile
