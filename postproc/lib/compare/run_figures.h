// SPDX-License-Identifier: GPL-2.0-or-later
// All that muckpile-post has measured of a run: the keys of its summary and its tables.
// Scope: files that are there; whether a run is as another one is comparison.h's.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "compare/table_curves.h"
#include "figures/figures.h"

namespace muckpile {

struct RunFigures {
  std::string name;                           // as the user gave it
  std::map<std::string, check::Json> values;  // numbers, texts, truth values, null; inner ones as
                                              // OUTER.INNER
  std::map<std::string, TableCurves> tables;  // profile.csv, crater.csv, heap.csv, fragments.csv,
                                              // sieve.csv
};

// `path` is a folder with summary.json, or such a file alone. Throws InputError, naming the file,
// if it cannot be read or is no summary of muckpile-post.
RunFigures read_run_figures(const std::filesystem::path& path);

}  // namespace muckpile
