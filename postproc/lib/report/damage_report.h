// SPDX-License-Identifier: GPL-2.0-or-later
// Sub-command damage: how far from the charges the joints are broken at the end.
// Scope: damage.csv, damage.png and keys of summary.json; docs/post/damage.md defines them.
#pragma once

#include <optional>

#include "io/result_folder.h"

namespace muckpile {

struct DamageOptions {
  std::optional<double> bin;  // width of the rings [m]; default: mean block size
};

// Throws NotMeasurable for a run without charges.
void report_damage(const ResultFolder& folder, const DamageOptions& options = {});

}  // namespace muckpile
