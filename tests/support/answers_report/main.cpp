// SPDX-License-Identifier: GPL-2.0-or-later
// answers_report CASE RESULTS [SCENE=PAGE]...: the tables of inputs/validation/responses.
// Scope: CASE holds runs.txt and answers.txt, RESULTS a folder of each run. Writes
// RESULTS/answers.csv and, for each scene named, RESULTS/SCENE.csv; where a page is named (SCENE=
// for none), a table of fewer columns goes there. Exit status 2 where anything is missing.
#include <exception>
#include <fstream>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

#include "args/input_error.h"
#include "tables.h"

namespace {

namespace fs = std::filesystem;
using namespace muckpile;

void write(const fs::path& path, const std::string& text) {
  std::ofstream out(path);
  out << text;
  if (!out.flush()) refuse(path.string(), "cannot be written");
}

std::pair<std::string, std::string> scene_and_page(const std::string& word) {
  const std::size_t equals = word.find('=');
  if (equals == std::string::npos) refuse("answers_report", "needs SCENE=PAGE, got '" + word + "'");
  return {word.substr(0, equals), word.substr(equals + 1)};
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) {
    std::cerr << "usage: " << argv[0] << " CASE RESULTS [SCENE=PAGE]...\n";
    return 2;
  }
  try {
    const fs::path of = argv[1], results = argv[2];
    const std::string answers = check::answers_table(of / "answers.txt", results);
    write(results / "answers.csv", answers);
    std::cout << answers;
    for (int k = 3; k < argc; ++k) {
      const auto [scene, page] = scene_and_page(argv[k]);
      const std::string table = check::runs_csv(of / "runs.txt", results, scene);
      write(results / (scene + ".csv"), table);
      std::cout << table;
      if (page.empty()) continue;
      const std::string shown = check::runs_table(of / "runs.txt", results, scene);
      write(page, check::with_table(page, scene, shown));
    }
  } catch (const std::exception& error) {
    std::cerr << "answers_report: " << error.what() << '\n';
    return 2;
  }
  return 0;
}
