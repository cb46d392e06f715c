// SPDX-License-Identifier: GPL-2.0-or-later
// make_page FOLDER: a made-up bench in a new folder with its pictures and its page, for
// page_in_browser.sh. Scope: tests only.
#include <cstdio>
#include <exception>

#include "report/reports.h"
#include "synthetic_run.h"

int main(int argc, char** argv) {
  using namespace muckpile;
  if (argc != 2) return 2;
  try {
    testing::write_bench(argv[1]);
    const ResultFolder folder(argv[1]);
    report_profile(folder, {testing::kCube, 0.125}, {});
    report_movement(folder, {testing::kCube, 0.125}, {});
    report_fragments(folder, {testing::kCube, {}});
    report_energy(folder);
    report_page(folder);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "make_page: %s\n", error.what());
    return 1;
  }
  return 0;
}
