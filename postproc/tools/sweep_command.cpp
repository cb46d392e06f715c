// SPDX-License-Identifier: GPL-2.0-or-later
// Sub-command sweep of muckpile-post.
// Scope: see the header.
#include "sweep_command.h"

#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "sweep/sweep_report.h"

namespace muckpile {
namespace {

struct SweepWords {
  std::string folder;
  std::vector<std::string> figures;
};

}  // namespace

void add_sweep_command(CLI::App& app) {
  const auto words = std::make_shared<SweepWords>();
  CLI::App* command = app.add_subcommand(
      "sweep",
      "sweep.csv, sweep_mean.csv, sweep_fit.csv, sweep.png: all runs of ./muckpile sweep, their "
      "spread over seeds, power laws and plots");
  command->add_option("folder", words->folder, "folder of the sweep; it holds sweep_runs.csv")
      ->required();
  command->add_option("--figures", words->figures,
                      "keys of summary.json to draw and fit (default: those that suit the scene)");
  command->callback([words] {
    for (const auto& file : report_sweep(words->folder, words->figures))
      std::printf("muckpile-post: %s\n", file.c_str());
  });
}

}  // namespace muckpile
