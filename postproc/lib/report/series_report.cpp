// SPDX-License-Identifier: GPL-2.0-or-later
// Sub-command series: snapshots as polyhedra, and how many there are.
// Scope: io/vtk_series writes them.
#include "io/vtk_series.h"
#include "report/reports.h"

namespace muckpile {

void report_series(const ResultFolder& folder, int every) {
  const int written = write_vtk_series(folder, every);
  nlohmann::ordered_json keys = common_keys(folder);
  keys["vtk_snapshots"] = written;
  folder.merge_into_summary(keys);
}

}  // namespace muckpile
