// SPDX-License-Identifier: GPL-2.0-or-later
// Dilution and ore loss of a dig line: a part of the sub-command movement.
// Scope: dig.csv, dig.png.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "io/ore_polygons.h"
#include "measure/survey_heights.h"
#include "report/options.h"
#include "report/run_data.h"

namespace muckpile {

// The keys of the summary that a dig line has.
const std::vector<std::string>& dig_keys();

// Digs within the polygons of options.dig. Ore is that of the block model's column where one is
// named, else that of `ore`, polygons before the blast in the run's axes. `pose` brings the axes of
// the files to those of the run. Returns the keys of the summary. Without a dig line takes away
// what an earlier call has left. Throws InputError where there is no ore, or a file is faulty.
nlohmann::ordered_json write_dig(const ResultFolder& folder, const RunData& run,
                                 const MovementOptions& options, const std::vector<OrePolygon>& ore,
                                 const SurveyPose& pose);

}  // namespace muckpile
