// SPDX-License-Identifier: GPL-2.0-or-later
// The runs of ./muckpile sweep: what was swept, and the figures of each run that has ended well.
// Scope: reads sweep_runs.csv, which the command writes, and summary.json and dump/scene.json of
// each run.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace muckpile {

struct SweptVariable {
  std::string name;
  std::string unit;                 // "" where no scene tells it
  std::vector<std::string> values;  // each once, in the order of the sweep
  std::vector<double> numbers;      // of the values; empty unless each is a number

  [[nodiscard]] std::string label() const;  // "burden [m]"
};

struct SweepRun {
  std::string folder;                     // within the sweep's
  std::string state;                      // done, or what else became of it
  std::vector<size_t> place;              // of its value among those of each variable
  std::string seed;                       // "" where none is swept
  std::map<std::string, double> figures;  // those with a value; of done runs only. True is 1

  [[nodiscard]] bool is_done() const { return state == "done"; }
  [[nodiscard]] std::optional<double> figure(const std::string& key) const;
};

struct Sweep {
  std::filesystem::path folder;
  std::string kind;                      // `case` of the runs; "" while none is done
  std::vector<SweptVariable> variables;  // without the seed, unless nothing else is swept
  bool is_sampled = false;               // values from ranges, another for each run
  bool has_seeds = false;                // each combination of values was run with several seeds
  std::vector<SweepRun> runs;            // in the order of the sweep
  std::vector<std::string> figures;      // every key that has a number in some run, by name

  // Values of the variables that the list names, in words: "burden 3 m, bench_height 9 m".
  [[nodiscard]] std::string words_for(const SweepRun& run, size_t first_variable) const;
};

// Throws InputError, naming the file and what is wrong with it, where the list is absent or
// malformed, the results of a done run are, or they are those of other values or another case.
[[nodiscard]] Sweep read_sweep(const std::filesystem::path& folder);

}  // namespace muckpile
