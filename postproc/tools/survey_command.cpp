// SPDX-License-Identifier: GPL-2.0-or-later
// Sub-command survey of muckpile-post.
// Scope: see the header.
#include "survey_command.h"

#include <cstdio>
#include <map>
#include <memory>
#include <string>

#include "command_words.h"
#include "report/mine_pose.h"
#include "report/reports.h"

namespace muckpile {
namespace {

const std::map<std::string, double> kUnits{{"m", 1.0}, {"mm", 1e-3}, {"cm", 1e-2}, {"ft", 0.3048}};

struct SurveyWords {
  std::string folder, unit = "m";
  MeasureOptions measure;
  SurveyOptions options;
  bool mine = false;
};

// The keys of the report, each on a line.
void print_figures(const ResultFolder& folder) {
  const nlohmann::ordered_json summary = read_json_object(folder.file("summary.json"));
  for (const auto& [key, value] : summary.items()) {
    if (key.starts_with("survey_")) std::printf("  %-30s %s\n", key.c_str(), value.dump().c_str());
  }
}

void survey(SurveyWords& words) {
  words.options.unit = kUnits.at(words.unit);
  const ResultFolder folder(words.folder);
  if (words.mine) set_mine_pose(folder, "survey", words.options.shift, words.options.turn_deg);
  report_survey(folder, words.measure, words.options);
  print_figures(folder);
}

}  // namespace

void add_survey_command(CLI::App& app) {
  const auto words = std::make_shared<SurveyWords>();
  SurveyOptions& options = words->options;
  CLI::App* command = app.add_subcommand(
      "survey",
      "the pile of a run against a surveyed surface: survey.csv, survey.png; volumes, heights, "
      "toes, vertical differences, distances");
  command->add_option("folder", words->folder, "result folder of the run; it holds dump/")
      ->required();
  command
      ->add_option("surface", options.surface,
                   "points x y z (.xyz, .csv, .txt, .las) or triangles (.stl, .dxf)")
      ->required();
  command->add_option("--shift", options.shift,
                      "of the surface along x, y and z [m], before it is turned")
      ->check(any_number());
  command->add_option("--turn", options.turn_deg,
                      "of the shifted surface about the run's z axis, counter-clockwise seen from "
                      "above [deg]")
      ->check(any_number());
  command
      ->add_flag("--mine", words->mine,
                 "the surface is in the coordinates of the mine that scene.json tells, in place of "
                 "--shift and --turn")
      ->excludes(command->get_option("--shift"))
      ->excludes(command->get_option("--turn"));
  command->add_option("--unit", words->unit, "of the file's numbers")->check(CLI::IsMember(kUnits));
  command
      ->add_option("--gap", options.gap,
                   "points farther apart in plan are not joined [m] (default: five times their "
                   "mean spacing)")
      ->check(above_zero());
  add_measure(command, words->measure);
  command->callback([words] { survey(*words); });
}

}  // namespace muckpile
