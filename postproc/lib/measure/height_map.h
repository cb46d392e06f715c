// SPDX-License-Identifier: GPL-2.0-or-later
// Heights of a bench before and after its blast over the plan, and what the blast left standing.
// Scope: tops of columns, as a survey from above would have them.
#pragma once

#include <vector>

#include "io/blocks_file.h"
#include "io/snapshot.h"
#include "measure/bench_planes.h"
#include "measure/columns.h"
#include "measure/pit_floor.h"

namespace muckpile {

// Per cell of the grid, the floor's where there is no rock above it [m].
struct HeightMap {
  ColumnGrid grid;
  std::vector<double> before, after, in_place;  // in_place: of the rock that stayed
  std::vector<double> floor;
  double pile_volume = 0.0;  // between the surface after and the rock that stayed or the floor [m3]
  double solid_volume = 0.0;  // of the broken-out rock that lies above the floor [m3]
};

// Columns over all rock before and after; blocks that `lies` leaves out make it no wider.
ColumnGrid plan_grid(const std::vector<StartBlock>& blocks, const Snapshot& last,
                     const std::vector<char>& lies, double cell);

// Blocks that `lies` leaves out are in no surface after.
HeightMap height_map(const std::vector<StartBlock>& blocks, const Snapshot& last,
                     const std::vector<char>& moved, const std::vector<char>& lies, double cell,
                     const PitFloor& floor = {});

// How far a blast reached beyond its holes [m].
struct Reach {
  double largest = 0.0;
  double mean = 0.0;  // over sections along the rows, each `section` wide
};

// Behind the row that stands `depth` behind the toe: level distance, at their own height, of the
// centroids of the chosen blocks that started above the floor and abreast of the holes.
Reach backbreak(const std::vector<StartBlock>& blocks, const std::vector<char>& chosen,
                const BenchPlanes& planes, double depth, double section);

// 1 for a block whose centroid has moved farther than `least` [m].
std::vector<char> shifted(const std::vector<StartBlock>& blocks, const Snapshot& last,
                          double least);
// 1 for a block of whose joint area more than half is broken.
std::vector<char> loosened(const Snapshot& last);

// Rock that stayed in front of the last row, above the floor.
struct ToeLeft {
  double volume = 0.0;  // [m3]
  double height = 0.0;  // of its highest point [m]
};
ToeLeft toe_left(const std::vector<StartBlock>& blocks, const Snapshot& last,
                 const std::vector<char>& moved, const BenchPlanes& planes, double depth);

}  // namespace muckpile
