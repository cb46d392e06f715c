// SPDX-License-Identifier: GPL-2.0-or-later
// The bench that the measures of `profile` are made for, and whether a run is one.
// Scope: a free face of any shape in front of the holes; holes parallel to each other that lean
// straight back or not at all, the front row burden behind the toe x = 0, z = 0; or any others
// whose burdens are known.
#pragma once

#include <vector>

#include "io/blocks_file.h"
#include "io/charges.h"
#include "io/result_folder.h"
#include "measure/bench_planes.h"
#include "report/section_plot.h"

namespace muckpile {

struct BenchScene {
  double height;                     // [m]
  double burden;                     // of the front row [m]
  double depth;                      // of the last row behind the toe, at the floor [m]
  double charge_top, charge_bottom;  // of the scene [m]
  double hole_radius;                // [m]
  std::vector<Charge> charges;
  bool one_row;
  BenchPlanes planes;     // with the width of the holes where a hole table says how they stand
  std::string face_note;  // what a face is that is no plane; "" for a plane
  bool several_sides;     // holes throw to more than one, so that no profile along x tells the pile
};

// Where a charge's axis meets the height of the floor (x, y) [m].
Vec2 foot_of(const Charge& charge);

// Throws NotMeasurable, with what is not as the measures assume, and InputError where scene.json
// lacks a number.
BenchScene bench_scene(const ResultFolder& folder, const std::vector<StartBlock>& blocks);

// The same; where it throws NotMeasurable, what an earlier call of the report has left is taken
// back first.
BenchScene bench_or_take_back(const ResultFolder& folder, const std::vector<StartBlock>& blocks,
                              const std::string& report, const nlohmann::ordered_json& own_keys);

// The planes with a width: where no hole table bounds it, the rock's before the blast.
BenchPlanes bounded_by_rock(BenchPlanes planes, const std::vector<StartBlock>& blocks);

// The face before the blast in the plane y, from the crest down to the toe (x, z) [m].
std::vector<Vec2> face_line(const BenchScene& bench, double y);

// Where the face was before the blast at a height [m], from y_low to y_high (x, y) [m].
std::vector<Vec2> face_at_height(const BenchScene& bench, double z, double y_low, double y_high);

// y of the front row's charge nearest to the middle of the rock's width [m]: one that throws along
// x, where there is one.
double y_of_middle_hole(const BenchScene& bench, const std::vector<StartBlock>& blocks);

// Charges and stemming of the holes that a section at y [m] cuts: of one beside it there is nothing
// to see.
std::vector<SectionBar> hole_bars(const BenchScene& bench, double y);

}  // namespace muckpile
