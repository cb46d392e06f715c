// SPDX-License-Identifier: GPL-2.0-or-later
// Sub-command damage of muckpile-post.
// Scope: see the header.
#include "damage_command.h"

#include <memory>
#include <string>

#include "command_words.h"
#include "report/damage_report.h"

namespace muckpile {
namespace {

struct DamageWords {
  std::string folder;
  DamageOptions options;
};

}  // namespace

void add_damage_command(CLI::App& app) {
  const auto words = std::make_shared<DamageWords>();
  CLI::App* command = app.add_subcommand("damage",
                                         "runs with charges: damage.csv, damage.png, cracks.csv, "
                                         "cracks.png; reach of the cracks from a "
                                         "hole on, broken share of the joints against the distance "
                                         "from the nearest charge");
  command->add_option("folder", words->folder, "result folder of the run; it holds dump/")
      ->required();
  command
      ->add_option("--bin", words->options.bin, "width of the rings [m] (default: mean block size)")
      ->check(above_zero());
  command->callback([words] { report_damage(ResultFolder(words->folder), words->options); });
}

}  // namespace muckpile
