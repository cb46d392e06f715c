// SPDX-License-Identifier: GPL-2.0-or-later
// What became of the rock of each hole of a blast: throw, velocity, moved volume.
// Scope: the rock of a hole is what started nearest to it; holes stand in rows behind the toe of
// the face, x = 0, z = 0.
#pragma once

#include <string>
#include <vector>

#include "explosive/hole_table.h"
#include "io/blocks_file.h"
#include "io/snapshot.h"
#include "measure/bench_planes.h"
#include "measure/scan_polygon.h"

namespace muckpile {

struct PatternHole {
  std::string name;
  int row;             // from 0, at the face
  Vec2 foot;           // where its axis meets the height of the floor (x, y) [m]
  Vec2 lean;           // way of the axis along x and y per height
  double firing_time;  // of its first deck [s]
  double charge;       // explosive of all its decks [kg]
};

// The holes of a table, by row from the face and along each row by y. Holes whose feet stand within
// half a burden behind the front one of a row are of that row. `masses` are the decks' [kg].
std::vector<PatternHole> pattern_holes(const HoleTable& table, const std::vector<double>& masses,
                                       double burden);
// By the rows of `frames`.
void number_rows(std::vector<PatternHole>& holes, const HoleFrames& frames);

// Number of the hole nearest to each block: in plan, from the block's centroid at the start to the
// hole's axis at that height. -1 for blocks that started below the floor, beside the width of
// `planes`, or farther behind the last row than half a burden [m].
std::vector<int> hole_of_blocks(const std::vector<StartBlock>& blocks,
                                const std::vector<PatternHole>& holes, const BenchPlanes& planes,
                                double burden);

// Of any set of blocks.
struct CastRock {
  int blocks = 0;
  double mass = 0.0;          // [kg]
  double volume = 0.0;        // [m3]
  double moved_volume = 0.0;  // of the blocks that were broken out [m3]
  double throw_mean = 0.0;    // displacement outwards of its mass centre [m]; NaN for no block
  double velocity = 0.0;  // greatest mean velocity outwards over the snapshots [m/s]; NaN for none
  double velocity_time = 0.0;  // when that was [s]
};

// Without the velocities, which add_velocity fills in snapshot by snapshot.
CastRock cast_rock(const std::vector<size_t>& chosen, const std::vector<StartBlock>& blocks,
                   const Snapshot& last, const std::vector<char>& moved,
                   const BenchPlanes& planes = {});
void add_velocity(CastRock& rock, const std::vector<size_t>& chosen,
                  const std::vector<StartBlock>& blocks, const Snapshot& now,
                  const BenchPlanes& planes = {});

}  // namespace muckpile
