// SPDX-License-Identifier: GPL-2.0-or-later
// Sub-command run-id of muckpile-post.
// Scope: see the header.
#include "run_id_command.h"

#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "args/input_error.h"
#include "io/run_id.h"

namespace muckpile {
namespace {

void print_run_id(const std::vector<std::string>& files) {
  const std::string first = run_id_in_json(files.front());
  for (const std::string& file : files)
    if (const std::string id = run_id_in_json(file); id != first)
      refuse(file, "is of run '" + id + "', but " + files.front() + " is of run '" + first + "'");
  std::printf("%s\n", first.c_str());
}

}  // namespace

void add_run_id_command(CLI::App& app) {
  const auto files = std::make_shared<std::vector<std::string>>();
  CLI::App* command =
      app.add_subcommand("run-id", "prints the id of the one run that these JSON files are of");
  command->group("");  // no page, no line of --help
  command->add_option("files", *files, "scene.json, run.json, summary.json")->required();
  command->callback([files] { print_run_id(*files); });
}

}  // namespace muckpile
