// SPDX-License-Identifier: GPL-2.0-or-later
// A block model of ore carried into the pile: a part of the sub-command movement.
// Scope: model_moved.csv.
#pragma once

#include <string>

#include "io/result_folder.h"
#include "measure/survey_heights.h"
#include "report/run_data.h"

namespace muckpile {

// A cell of the model, a row of `file` with x_m, y_m and z_m of its middle, goes where the block of
// the run goes that it lay in, turned with it. All columns of the file are kept. `pose` brings the
// file's axes to the run's; where a cell went is told in the file's. Returns the keys of the
// summary. Throws InputError where no cell lies in a block, or a field is no number. Without a file
// takes away what an earlier call has left.
nlohmann::ordered_json write_ore_model(const ResultFolder& folder, const RunData& run,
                                       const std::string& file, const SurveyPose& pose);

}  // namespace muckpile
