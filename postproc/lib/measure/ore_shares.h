// SPDX-License-Identifier: GPL-2.0-or-later
// Which share of each block of a run is ore, by polygons or by the cells of a block model.
// Scope: places before the blast.
#pragma once

#include <string>
#include <vector>

#include "io/blocks_file.h"
#include "io/ore_polygons.h"
#include "measure/survey_heights.h"

namespace muckpile {

// From the axes of its file to the run's.
OrePolygon placed(OrePolygon polygon, const SurveyPose& pose);

// 1 for blocks whose centroid started in one of the polygons, else 0.
std::vector<double> ore_in_polygons(const std::vector<OrePolygon>& polygons,
                                    const std::vector<StartBlock>& blocks);

struct OreCell {
  Vec3 middle;  // in the model's axes [m]
  bool is_ore;
};

// Of a block with middles of cells in it, the share of those that are ore. Another one is of the
// cell that its centroid lies in, and waste if there is none. Cells are of one size, on a grid
// along the model's axes, which `pose` brings to the run's.
std::vector<double> ore_of_cells(const std::vector<OreCell>& cells, const SurveyPose& pose,
                                 const std::vector<StartBlock>& blocks);

}  // namespace muckpile
