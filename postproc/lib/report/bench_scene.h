// SPDX-License-Identifier: GPL-2.0-or-later
// The bench that the measures of `profile` are made for, and whether a run is one.
// Scope: vertical free face x = 0, pit floor z = 0, vertical holes whose front row stands at
// x = -burden.
#pragma once

#include <vector>

#include "io/blocks_file.h"
#include "io/charges.h"
#include "io/result_folder.h"
#include "report/section_plot.h"

namespace muckpile {

struct BenchScene {
  double height;                     // [m]
  double burden;                     // of the front row [m]
  double depth;                      // of the last row behind the face [m]
  double charge_top, charge_bottom;  // of the scene [m]
  double hole_radius;                // [m]
  std::vector<Charge> charges;
  bool one_row;
};

// Throws NotMeasurable, with what is not as the measures assume, and InputError where scene.json
// lacks a number.
BenchScene bench_scene(const ResultFolder& folder, const std::vector<StartBlock>& blocks);

// y of the front row's charge nearest to the middle of the rock's width [m].
double y_of_middle_hole(const BenchScene& bench, const std::vector<StartBlock>& blocks);

// Charges and stemming of the holes that a section at y [m] cuts: of one beside it there is nothing
// to see.
std::vector<SectionBar> hole_bars(const BenchScene& bench, double y);

}  // namespace muckpile
