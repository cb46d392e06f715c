// SPDX-License-Identifier: GPL-2.0-or-later
// The line that a user draws in plan, in the run's axes.
// Scope: two points, of the run or of its mine.
#pragma once

#include <string>

#include "io/result_folder.h"
#include "measure/plan_line.h"
#include "report/options.h"

namespace muckpile {

// Throws InputError, in the name of the report, for points that are one, and for points of the mine
// where the run does not say where it stands there.
PlanLine plan_line_of(const ResultFolder& folder, const LineOptions& options,
                      const std::string& report);

// "from x = -5, y = 0 to x = 10, y = 0 m".
std::string words_of(const PlanLine& line);

}  // namespace muckpile
