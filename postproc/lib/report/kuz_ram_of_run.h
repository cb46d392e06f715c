// SPDX-License-Identifier: GPL-2.0-or-later
// Kuz-Ram for the blast of a run: what the formula needs, from scene.json and the user.
// Scope: benches that say burden, spacing, height, hole, charge and explosive; else a reason.
#pragma once

#include <optional>
#include <string>

#include "io/result_folder.h"
#include "measure/kuz_ram.h"
#include "report/options.h"

namespace muckpile {

struct KuzRamOfRun {
  std::optional<KuzRamCurve> curve;
  std::string note;  // the formula with its rock factor and weight strength, or why there is none
};

KuzRamOfRun kuz_ram_of(const ResultFolder& folder, const FragmentOptions& options);

}  // namespace muckpile
