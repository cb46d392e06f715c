// SPDX-License-Identifier: GPL-2.0-or-later
// The muck pile of a bench blast: its profile, throw, swell and slope.
// Scope: free face at x = 0, throw along +x; docs/post/profile.md defines each
// measure.
#pragma once

#include <vector>

#include "io/blocks_file.h"
#include "io/snapshot.h"
#include "measure/bench_planes.h"
#include "measure/columns.h"
#include "measure/pit_floor.h"

namespace muckpile {

// Heights [m] over z = 0 at each x of the grid; where there is no rock above the floor the floor's.
struct PileProfile {
  std::vector<double> x;              // [m]
  std::vector<double> before;         // top of the bench, mean over y
  std::vector<double> mean;           // top of all rock after, mean over y
  std::vector<double> centre;         // top of all rock after, at the middle of the width
  std::vector<double> highest;        // top of all rock after, highest over y
  std::vector<double> rock_in_place;  // top of the rock that stayed, mean over y
  std::vector<double> pile;           // top of the broken-out rock, mean over y
  std::vector<double> pile_length;    // rock of the pile in a column [m], mean over y
  // Top of the broken-out rock again, mean over y of each of the sections two blocks wide that the
  // width is cut into.
  std::vector<std::vector<double>> sections, section_floors;
  std::vector<double> floor;  // mean over y; empty, as section_floors: level at 0
  double dx;                  // [m]
  double width;               // along y [m]
};

// Blocks that `lies` leaves out are in no surface after. Abreast of the holes of `planes`.
PileProfile pile_profile(const std::vector<StartBlock>& blocks, const Snapshot& last,
                         const std::vector<char>& moved, double cell, const std::vector<char>& lies,
                         const BenchPlanes& planes = {}, const PitFloor& floor = {});

struct PileShape {
  static PileShape none();  // no measure has a meaning

  double height, height_x;  // of `pile` above the floor, where it is highest, and where [m]
  double toe;               // where the pile becomes thinner than one mean block for good [m]
  double toe_98;            // 98 % of the pile's rock beyond the face lies behind [m]
  double swell;             // bulk over solid volume, between the face and the toe
  double bulk_volume, solid_volume;  // beyond the face, to the toe [m3]
  double front_angle;  // of the line through the front slope, 20 to 80 % of the height [rad]
  double rest_angle;   // steepest line over a stretch as long as the pile is high, four blocks at
                       // least, mean of the sections [rad]
};

// NaN where a measure has no meaning, e.g. a slope without a pile. `depth` is the distance of the
// last row of holes behind the face, `block_size` that of the pile [m].
PileShape pile_shape(const PileProfile& profile, double depth, double block_size);

struct Throw {
  double prism_mass;      // of the burden prism: blocks that start in front of the front row [kg]
  double prism_volume;    // [m3]
  double centre_of_mass;  // mean displacement of the prism along x [m]
  double largest;         // largest displacement along x of one block [m]
  double beyond_toe;      // share of the prism's mass that ends beyond the bench's toe, x = 0
};

Throw throw_of(const std::vector<StartBlock>& blocks, const Snapshot& last, double burden,
               const BenchPlanes& planes = {});

}  // namespace muckpile
