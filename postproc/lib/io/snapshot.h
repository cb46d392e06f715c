// SPDX-License-Identifier: GPL-2.0-or-later
// Where every block is at one instant, from a run's dump/blocks_<step>.csv or .bin.
// Scope: every block of the start configuration has exactly one row; nothing is interpolated.
#pragma once

#include <filesystem>
#include <vector>

#include "io/blocks_file.h"
#include "math/types.h"

namespace muckpile {

struct BlockState {
  Vec3 centre;             // [m]
  Quat rotation;           // from the start orientation
  Vec3 velocity;           // [m/s]
  Vec3 spin;               // [rad/s]
  int fragment;            // smallest block id of the fragment
  double broken_fraction;  // of the block's joint area
};

struct Snapshot {
  long step = 0;
  double time = 0.0;               // [s]
  std::vector<BlockState> states;  // in the order of the start blocks
};

// The files blocks_<step>.csv and .bin of a dump folder in order of step; none is no error.
std::vector<std::filesystem::path> snapshot_files(const std::filesystem::path& dump);

// With the states of images that the blocks hold. Throws InputError, naming file and line, on a
// malformed row, an unknown or repeated id, or a missing block.
Snapshot read_snapshot(const std::filesystem::path& path, const std::vector<StartBlock>& blocks);

// A point [m] of the block at the start, moved with the block as a rigid body.
inline Vec3 moved_point(const StartBlock& block, const BlockState& state, const Vec3& point) {
  return state.centre + state.rotation * (point - block.centroid);
}

// All vertices [m] of the block in its present pose.
std::vector<Vec3> moved_vertices(const StartBlock& block, const BlockState& state);

// The blocks at rest where they started, as a snapshot of time 0.
Snapshot start_snapshot(const std::vector<StartBlock>& blocks);

}  // namespace muckpile
