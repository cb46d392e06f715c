// SPDX-License-Identifier: GPL-2.0-or-later
// Sub-command burden: the burden of each hole along its charge.
// Scope: runs whose create_blocks has written dump/burden.csv; no snapshot is needed.
#pragma once

#include "io/result_folder.h"

namespace muckpile {

// burden.csv, burden.png and keys. Throws NotMeasurable for a run without holes there.
void report_burden(const ResultFolder& folder);

}  // namespace muckpile
