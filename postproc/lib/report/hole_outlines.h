// SPDX-License-Identifier: GPL-2.0-or-later
// The polygons of rock of a run's holes, at half the height of the bench.
// Scope: benches that rows measures.
#pragma once

#include <vector>

#include "measure/hole_polygons.h"
#include "report/bench_scene.h"

namespace muckpile {

// Of the hole table; none without one.
std::vector<HolePolygon> hole_outlines(const ResultFolder& folder, const BenchScene& bench,
                                       const std::vector<StartBlock>& blocks);

// hole_polygons.csv: corners of each part, counter-clockwise; clockwise of what is cut out of it.
void write_hole_outlines(const ResultFolder& folder, const std::vector<HolePolygon>& outlines,
                         double height);

}  // namespace muckpile
