// SPDX-License-Identifier: GPL-2.0-or-later
// What became of the rock of each hole of a blast: throw, velocity, moved volume.
// Scope: the rock of a hole is its burden, what started between it and the row in front of it, or
// the face; holes stand in rows behind the toe of the face, x = 0, z = 0.
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

// Where its axis is at a height [m].
Vec2 axis_at(const PatternHole& hole, double height);
// Of the row that begins with a hole, the end.
size_t end_of_row(const std::vector<PatternHole>& holes, size_t first);
// Of such a row, the hole next to a place across the throw, along y.
size_t hole_beside(const std::vector<PatternHole>& holes, size_t first, const Vec3& p);

// Of a hole that is next to a place along y: whether it breaks rock so far aside, half a spacing or
// half way to a neighbour of its row.
bool reaches(const std::vector<PatternHole>& holes, size_t hole, const Vec3& p, double spacing);

// Number of the hole whose burden each block was by its centroid at the start: of the first row
// from the face whose next hole, along y, stands behind it at its height and reaches it; where none
// reaches it, of the first that stands behind it. Where holes throw to several sides, as
// HoleFrames::hole_of tells. -1 for blocks that started behind all of them, below the floor, or
// beside the width of `planes`.
std::vector<int> hole_of_blocks(const std::vector<StartBlock>& blocks,
                                const std::vector<PatternHole>& holes, const BenchPlanes& planes);

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
