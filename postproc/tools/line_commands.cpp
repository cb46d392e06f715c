// SPDX-License-Identifier: GPL-2.0-or-later
// Sub-commands of muckpile-post that measure any geometry.
// Scope: see the header.
#include "line_commands.h"

#include <memory>
#include <string>

#include "command_words.h"
#include "report/reports.h"

namespace muckpile {
namespace {

struct LineWords {
  std::string folder;
  MeasureOptions measure;
  LineOptions line;
  TroughOptions trough;
};

// The folder, how a pile is measured, and the line.
CLI::App* add_line_command(CLI::App& app, const char* name, const char* help, LineWords& words) {
  CLI::App* command = add_command(app, name, help, words.folder);
  add_measure(command, words.measure);
  command->add_option("--from", words.line.from, "X Y of a point of the line [m]")
      ->required()
      ->check(any_number());
  command->add_option("--to", words.line.to, "X Y of another one [m]")
      ->required()
      ->check(any_number());
  command->add_flag("--mine", words.line.mine,
                    "the points are east and north of the mine, not x and y of the run");
  return command;
}

void add_section_command(CLI::App& app) {
  const auto o = std::make_shared<LineWords>();
  CLI::App* section = add_line_command(
      app, "section", "section.csv, section.png: rock and heights along any line in plan", *o);
  section
      ->add_option("--width", o->line.width,
                   "over which heights are averaged [m] (default: of one column)")
      ->check(above_zero());
  add_colour(section, o->line.colour_by);
  section->callback([o] { report_section(ResultFolder(o->folder), o->measure, o->line); });
}

void add_over_command(CLI::App& app) {
  const auto o = std::make_shared<LineWords>();
  CLI::App* over = add_line_command(
      app, "over", "over.csv, over.png: volume and mass that went over a line in plan", *o);
  over->callback([o] { report_over(ResultFolder(o->folder), o->measure, o->line); });
}

void add_trough_command(CLI::App& app) {
  const auto o = std::make_shared<LineWords>();
  CLI::App* trough = add_command(app, "trough",
                                 "bench at rest: trough.csv, trough.png; the valley between the "
                                 "rock that stands and the pile",
                                 o->folder);
  add_measure(trough, o->measure);
  trough
      ->add_option("--strip", o->trough.strip,
                   "width of a section along y [m] (default: the spacing of the holes, or two "
                   "mean blocks)")
      ->check(above_zero());
  trough->callback([o] { report_trough(ResultFolder(o->folder), o->measure, o->trough); });
}

}  // namespace

void add_line_commands(CLI::App& app) {
  add_section_command(app);
  add_over_command(app);
  add_trough_command(app);
}

}  // namespace muckpile
