// SPDX-License-Identifier: GPL-2.0-or-later
// Where the parts of a bench went: means over bands of start level and of distance behind the face.
// Scope: all rock that started in a part, whether it was broken out or not; bench coordinates.
#pragma once

#include <vector>

#include "io/blocks_file.h"
#include "io/snapshot.h"
#include "measure/bench_planes.h"

namespace muckpile {

struct BenchParts {
  double height, depth;   // of the rock in front of the last row of holes [m]
  int levels, distances;  // bands over each, equally thick
  BenchPlanes planes{};
};

// Of any set of blocks.
struct RockMovement {
  int blocks = 0;
  double mass = 0.0;          // [kg]
  double moved = 0.0;         // share of it that was broken out
  Vec3 start = Vec3::Zero();  // centre of mass [m]
  Vec3 end = Vec3::Zero();    // [m]
  double spread = 0.0;        // root mean square of displacements about their mean [m]
  [[nodiscard]] Vec3 displacement() const { return end - start; }
};

// The blocks by index, one at least.
RockMovement movement_of(const std::vector<size_t>& chosen, const std::vector<StartBlock>& blocks,
                         const Snapshot& last, const std::vector<char>& moved);

struct PartMovement {
  int level, distance;           // from the floor up, from the face back; from 0
  double level_low, level_high;  // [m]
  double near, far;              // behind the face [m]
  RockMovement rock;
};

// Parts in which blocks started, by their centroids; levels from below, within each from the face.
std::vector<PartMovement> movement_of_parts(const std::vector<StartBlock>& blocks,
                                            const Snapshot& last, const std::vector<char>& moved,
                                            const BenchParts& parts);

// The level of each block; -1 for those outside of the parts.
std::vector<int> levels_of(const std::vector<StartBlock>& blocks, const BenchParts& parts);

}  // namespace muckpile
