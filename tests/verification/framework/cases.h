// SPDX-License-Identifier: GPL-2.0-or-later
// main() of a verification program: runs one of its named cases.
// Scope: PROGRAM CASE FOLDER; exit status 0, 1 if a row failed, 2 if the case could not run.
#pragma once

#include <functional>
#include <map>
#include <string>

#include "framework/report.h"

namespace muckpile::verification {

using Cases = std::map<std::string, std::function<void(Report&)>>;

/// `topic` and the case name the report.
int run_case(const std::string& topic, const Cases& cases, int argc, char** argv);

}  // namespace muckpile::verification
