// SPDX-License-Identifier: GPL-2.0-or-later
// Sub-command fragments of muckpile-post.
// Scope: see the header.
#include "fragments_command.h"

#include <memory>
#include <string>

#include "command_words.h"
#include "report/reports.h"

namespace muckpile {
namespace {

struct FragmentWords {
  std::string folder;
  MeasureOptions measure;
  FragmentOptions options;
};

void add_sizes(CLI::App* command, FragmentOptions& options) {
  command
      ->add_option("--boulder", options.boulder,
                   "write fragments of a larger sieve size [m] to boulders.csv, with their places")
      ->check(CLI::PositiveNumber);
  command
      ->add_option("--rock-factor", options.rock_factor,
                   "A of Kuz-Ram (default: Lilly's index of the run's rock)")
      ->check(CLI::PositiveNumber);
  command
      ->add_option("--mass-rating", options.mass_rating,
                   "of Lilly's index: 10 powdery, 50 massive, more where joints decide")
      ->check(CLI::PositiveNumber);
  command
      ->add_option(
          "--rws", options.weight_strength,
          "weight strength of the explosive for Kuz-Ram, ANFO 100 (default: by its energy)")
      ->check(CLI::PositiveNumber);
  command
      ->add_option("--drilling-deviation", options.drilling_deviation,
                   "of the holes at their toe, for Kuz-Ram [m]")
      ->check(CLI::NonNegativeNumber);
}

}  // namespace

void add_fragments_command(CLI::App& app) {
  const auto o = std::make_shared<FragmentWords>();
  CLI::App* fragments =
      add_command(app, "fragments",
                  "size curves by sieve and volume, fits, Kuz-Ram, boulders: fragments.csv, "
                  "sieve.csv, fragments_list.csv, fragments.png",
                  o->folder);
  add_measure(fragments, o->measure);
  add_sizes(fragments, o->options);
  fragments->callback([o] { report_fragments(ResultFolder(o->folder), o->measure, o->options); });
}

}  // namespace muckpile
