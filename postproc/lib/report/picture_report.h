// SPDX-License-Identifier: GPL-2.0-or-later
// Sub-command render with a section along any line.
// Scope: report_picture of report/reports.h beside it.
#pragma once

#include "io/result_folder.h"
#include "report/options.h"

namespace muckpile {

// As report_picture(folder, options), but the rock between the eye and the upright plane through
// the line is cut away. Throws InputError for a line that is none.
void report_picture(const ResultFolder& folder, const PictureOptions& options,
                    const LineOptions& line);

}  // namespace muckpile
