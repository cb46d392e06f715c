// SPDX-License-Identifier: GPL-2.0-or-later
// Sub-command sample of muckpile-post.
// Scope: see the header.
#include "sample_command.h"

#include <algorithm>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "args/input_error.h"
#include "sweep/latin_hypercube.h"

namespace muckpile {
namespace {

struct SampleWords {
  std::vector<std::string> ranges;
  int runs = 0, seed = 1;
};

void print_samples(const SampleWords& words) {
  std::vector<SampledRange> ranges;
  for (const std::string& range : words.ranges) {
    ranges.push_back(parse_range(range));
    if (std::ranges::count(ranges, ranges.back().name, &SampledRange::name) > 1)
      throw InputError("sample: each variable once, got '" + ranges.back().name + "' twice");
  }
  const auto design = latin_hypercube(static_cast<size_t>(words.runs), ranges.size(),
                                      static_cast<std::uint64_t>(words.seed));
  for (const std::vector<double>& run : design) {
    for (size_t k = 0; k < ranges.size(); ++k)
      std::printf("%s%s", k == 0 ? "" : "\t", sampled_value(ranges[k], run[k]).c_str());
    std::printf("\n");
  }
}

}  // namespace

void add_sample_command(CLI::App& app) {
  const auto words = std::make_shared<SampleWords>();
  CLI::App* command = app.add_subcommand(
      "sample",
      "prints values for runs that fill the ranges of uncertain variables evenly (Latin "
      "hypercube), a line for each run; ./muckpile sweep -samples takes them");
  command->add_option("ranges", words->ranges, "NAME=FROM..TO, or NAME=log:FROM..TO")->required();
  command->add_option("--runs", words->runs, "how many")->required()->check(CLI::Range(1, 9999));
  command->add_option("--seed", words->seed, "another one gives other values")
      ->check(CLI::Range(0, 1 << 30));
  command->callback([words] { print_samples(*words); });
}

}  // namespace muckpile
