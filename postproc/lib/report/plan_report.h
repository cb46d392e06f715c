// SPDX-License-Identifier: GPL-2.0-or-later
// Sub-command plan: the pattern from above with the times at which it fires.
// Scope: works on a hole table alone, before any run.
#pragma once

#include <filesystem>

namespace muckpile {

// `what` is a hole table (CSV), then its picture lies beside it as .png; or a result folder with
// dump/holes.csv, then plan.png and summary keys. Throws InputError on a faulty table,
// NotMeasurable where a folder has none.
void report_plan(const std::filesystem::path& what);

}  // namespace muckpile
