// SPDX-License-Identifier: GPL-2.0-or-later
// Sub-command report: the page of a run as one file.
// Scope: page/run_page says what is on it.
#include <fstream>

#include "args/input_error.h"
#include "page/run_page.h"
#include "report/reports.h"

namespace muckpile {

void report_page(const ResultFolder& folder) {
  const std::string page = page_of(folder);
  const auto path = folder.file("report.html");
  std::ofstream out(path, std::ios::binary);
  out << page;
  if (!out.flush()) refuse(path.string(), "cannot be written");
}

}  // namespace muckpile
