// SPDX-License-Identifier: GPL-2.0-or-later
// What --mine stands for: files and points of the mine, for a run that says where it is in it.
// Scope: see io/mine_frame.h.
#pragma once

#include <array>
#include <string>

#include "io/mine_frame.h"

namespace muckpile {

// Throws InputError, in the name of the report and with what to give instead, where there is none.
MineFrame required_mine_frame(const ResultFolder& folder, const std::string& report,
                              const std::string& instead);

// Shift [m] and turn [deg] from the mine's axes to the run's, as of SurveyPose
// (measure/survey_heights.h).
void set_mine_pose(const ResultFolder& folder, const std::string& report,
                   std::array<double, 3>& shift, double& turn_deg);

}  // namespace muckpile
