// SPDX-License-Identifier: GPL-2.0-or-later
// The page of a run: what was blasted, what came of it, how far it holds, and how to make it again.
// Scope: of what is in the folder; nothing is measured or drawn anew but the chart of speeds.
#pragma once

#include <string>

#include "io/result_folder.h"

namespace muckpile {

// Throws InputError where summary.json is absent, of another run or no summary, or a picture is
// cut.
std::string page_of(const ResultFolder& folder);

}  // namespace muckpile
