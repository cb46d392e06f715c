// SPDX-License-Identifier: GPL-2.0-or-later
// Polygons of ore carried into the pile: a part of the sub-command movement.
// Scope: polygons.csv, polygons_moved.csv, polygons.dxf, polygons.png.
#pragma once

#include <string>
#include <vector>

#include "io/ore_polygons.h"
#include "io/result_folder.h"
#include "measure/survey_heights.h"
#include "report/run_data.h"

namespace muckpile {

// Polygons in the run's axes; `pose` brings those of their file to them, in which the outlines are
// written. Throws InputError, naming their `file`, where no block started in a polygon. Without
// polygons takes away what an earlier call has left.
void write_polygons(const ResultFolder& folder, const RunData& run,
                    const std::vector<OrePolygon>& polygons, const SurveyPose& pose,
                    const std::string& file);

}  // namespace muckpile
