// SPDX-License-Identifier: GPL-2.0-or-later
// Sub-commands of muckpile-post that measure a pile or crater.
// Scope: see the header.
#include "pile_commands.h"

#include <memory>
#include <string>

#include "command_words.h"
#include "report/reports.h"

namespace muckpile {
namespace {

struct PileWords {
  std::string folder;
  MeasureOptions measure;
  SectionOptions section;
};

using SectionReport = void (*)(const ResultFolder&, const MeasureOptions&, const SectionOptions&);
using PlanReport = void (*)(const ResultFolder&, const MeasureOptions&);

void add_section(CLI::App& app, const char* name, const char* help, SectionReport report) {
  const auto words = std::make_shared<PileWords>();
  CLI::App* command = add_command(app, name, help, words->folder);
  add_measure(command, words->measure);
  add_colour(command, words->section.colour_by);
  command->add_option("--y", words->section.y, "place of the section [m] (default: through a hole)")
      ->check(any_number());
  command->callback(
      [words, report] { report(ResultFolder(words->folder), words->measure, words->section); });
}

void add_plan_view(CLI::App& app, const char* name, const char* help, PlanReport report) {
  const auto words = std::make_shared<PileWords>();
  CLI::App* command = add_command(app, name, help, words->folder);
  add_measure(command, words->measure);
  command->callback([words, report] { report(ResultFolder(words->folder), words->measure); });
}

}  // namespace

void add_pile_commands(CLI::App& app) {
  add_section(app, "profile", "bench: profile.csv, profile.png; throw, height, toe, swell, slope",
              report_profile);
  add_section(app, "crater", "crater: crater.csv, crater.png; radius, depth, volume, ejecta",
              report_crater);
  add_section(app, "heap", "heap: heap.csv, heap.png; angle of repose, height, toe, swell",
              report_heap);
  add_plan_view(app, "rows",
                "bench with a hole table: rows.csv, face_velocity.csv, face_velocity.png; what "
                "became of the rock of each hole and row",
                report_rows);
  add_plan_view(app, "heights",
                "bench: heights.csv, heights.png; pile and bench from above, backbreak, toe left, "
                "volumes",
                report_heights);
}

}  // namespace muckpile
