// SPDX-License-Identifier: GPL-2.0-or-later
// All that muckpile-post has measured of a run.
// Scope: see the header.
#include "compare/run_figures.h"

#include "args/input_error.h"

namespace muckpile {
namespace {

void add_values(const check::Json& object, const std::string& prefix, RunFigures& run) {
  for (const auto& [key, value] : object.items()) {
    if (value.is_structured()) {
      add_values(value, prefix + key + ".", run);
    } else {
      run.values[prefix + key] = value;
    }
  }
}

}  // namespace

RunFigures read_run_figures(const std::filesystem::path& path) {
  const bool is_folder = std::filesystem::is_directory(path);
  const std::filesystem::path file = is_folder ? path / "summary.json" : path;
  const check::Json summary = check::read_json_object(file);
  // Every command writes it.
  if (!summary.contains("case") || !summary["case"].is_string())
    refuse(file.string(), "is no summary of muckpile-post: it has no text 'case'");
  RunFigures run{path.string(), {}, {}};
  add_values(summary, "", run);
  if (!is_folder) return run;
  for (const char* table :
       {"profile.csv", "crater.csv", "heap.csv", "fragments.csv", "sieve.csv"}) {
    if (std::filesystem::exists(path / table)) run.tables[table] = read_curves(path / table);
  }
  return run;
}

}  // namespace muckpile
