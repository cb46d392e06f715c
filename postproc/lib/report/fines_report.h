// SPDX-License-Identifier: GPL-2.0-or-later
// Fines by a law beside the simulated size curve: a part of the sub-command fragments.
// Scope: fines.csv, fines.png; the tables and pictures of what was simulated know nothing of them.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "measure/fragments.h"
#include "report/options.h"
#include "report/run_data.h"

namespace muckpile {

// The keys of the summary that the law has.
const std::vector<std::string>& fines_keys();

// `sieves` are those of the run's fragments, in the order of `fragments`. Returns the keys of the
// summary. Without a law takes away what an earlier call has left. Throws InputError where the run
// has no charges, or does not tell the diameter of their holes.
nlohmann::ordered_json write_fines(const ResultFolder& folder, const RunData& run,
                                   const std::vector<Fragment>& fragments,
                                   const std::vector<double>& sieves,
                                   const FragmentOptions& options);

}  // namespace muckpile
