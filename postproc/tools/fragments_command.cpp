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
      ->add_option(
          "--boulder", options.boulder,
          "write fragments of a larger sieve size [m] to boulders.csv, with their places, and "
          "draw them: boulders.png")
      ->check(above_zero());
  command
      ->add_option("--rock-factor", options.rock_factor,
                   "A of Kuz-Ram (default: Lilly's index of the run's rock)")
      ->check(above_zero());
  command
      ->add_option("--mass-rating", options.mass_rating,
                   "of Lilly's index: 10 powdery, 50 massive, more where joints decide")
      ->check(above_zero());
  command
      ->add_option(
          "--rws", options.weight_strength,
          "weight strength of the explosive for Kuz-Ram, ANFO 100 (default: by its energy)")
      ->check(above_zero());
  command
      ->add_option("--drilling-deviation", options.drilling_deviation,
                   "of the holes at their toe, for Kuz-Ram [m]")
      ->check(at_least_zero());
}

void add_fines(CLI::App* command, FragmentOptions& options) {
  CLI::Option* fines =
      command
          ->add_option("--fines", options.fines_radius,
                       "fines by a law, no simulation: rock within this many hole radii of a "
                       "charge is crushed; fines.csv, fines.png (default: none)")
          ->check(between(1.0, 20.0));
  command->add_option("--fines-top", options.fines_top, "99 % of the fines pass this size [m]")
      ->check(between(1e-6, 1.0))
      ->needs(fines);
  command
      ->add_option("--fines-exponent", options.fines_exponent,
                   "of the Rosin-Rammler curve of the fines")
      ->check(between(0.2, 5.0))
      ->needs(fines);
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
  add_fines(fragments, o->options);
  fragments->callback([o] { report_fragments(ResultFolder(o->folder), o->measure, o->options); });
}

}  // namespace muckpile
