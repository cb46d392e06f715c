// SPDX-License-Identifier: GPL-2.0-or-later
// Sub-command overlay of muckpile-post.
// Scope: see the header.
#include "overlay_command.h"

#include <cstdio>
#include <memory>

#include "sweep/overlay_report.h"

namespace muckpile {

void add_overlay_command(CLI::App& app) {
  const auto options = std::make_shared<OverlayOptions>();
  CLI::App* command = app.add_subcommand(
      "overlay",
      "a table of several runs, one over the other, with the band from P10 to P90: "
      "overlay_TABLE.csv, overlay_TABLE.png; of polygons, holes or parts of a bench the scatter of "
      "each");
  command
      ->add_option("runs", options->runs, "result folders, two at least, with several seeds, say")
      ->required();
  command->add_option("--table", options->table,
                      "which table of each: profile.csv, fragments.csv, sieve.csv, crater.csv, "
                      "heap.csv, movement.csv, polygons.csv, rows.csv ...");
  command->add_option("--columns", options->columns,
                      "of the table (default: all that every run has)");
  command->add_option("--out", options->out, "folder for what is written");
  command->callback([options] {
    for (const auto& file : report_overlay(*options))
      std::printf("muckpile-post: %s\n", file.c_str());
  });
}

}  // namespace muckpile
