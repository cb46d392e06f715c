// SPDX-License-Identifier: GPL-2.0-or-later
// Sub-command movement of muckpile-post.
// Scope: see the header.
#include "movement_command.h"

#include <memory>
#include <string>

#include "command_words.h"
#include "report/mine_pose.h"
#include "report/reports.h"

namespace muckpile {
namespace {

struct MovementWords {
  std::string folder;
  MeasureOptions measure;
  MovementOptions options;
  bool mine = false;
};

}  // namespace

void add_movement_command(CLI::App& app) {
  const auto o = std::make_shared<MovementWords>();
  CLI::App* movement =
      add_command(app, "movement",
                  "bench: movement.csv, movement.dxf, movement.png; where its parts went, by "
                  "level and distance from the face",
                  o->folder);
  add_measure(movement, o->measure);
  movement->add_option("--levels", o->options.levels, "bands of height")->check(CLI::Range(1, 8));
  movement->add_option("--distances", o->options.distances, "bands of distance from the face")
      ->check(CLI::Range(1, 20));
  movement
      ->add_option("--polygons", o->options.polygons,
                   "polygons of ore to carry into the pile (CSV: polygon, x_m, y_m, z_low_m, "
                   "z_high_m): polygons.csv, polygons_moved.csv, polygons.dxf, polygons.png")
      ->check(CLI::ExistingFile);
  movement
      ->add_option(
          "--model", o->options.model,
          "block model to carry into the pile (CSV: x_m, y_m, z_m of the middles, and what "
          "else it has): model_moved.csv")
      ->check(CLI::ExistingFile);
  CLI::Option* dig =
      movement
          ->add_option("--dig", o->options.dig,
                       "polygons within which the pile is dug, at levels (CSV as --polygons): "
                       "dig.csv, dig.png, dilution and ore loss; ore is what lies in --polygons, "
                       "or of --ore-column")
          ->check(CLI::ExistingFile);
  CLI::Option* column = movement
                            ->add_option("--ore-column", o->options.ore_column,
                                         "of --model: cells with --cutoff or more in it are ore")
                            ->needs(dig);
  movement->add_option("--cutoff", o->options.cutoff, "in the column's unit")
      ->check(any_number())
      ->needs(column);
  movement->add_option("--shift", o->options.shift,
                       "of polygons and model along x, y and z [m], before they are turned; "
                       "drawings and moved places are in their axes")
      ->check(any_number());
  movement->add_option("--turn", o->options.turn_deg,
                       "of the shifted ones about the run's z axis, counter-clockwise seen from "
                       "above [deg]")
      ->check(any_number());
  movement
      ->add_flag("--mine", o->mine,
                 "polygons and model are in the coordinates of the mine that scene.json tells, in "
                 "place of --shift and --turn")
      ->excludes(movement->get_option("--shift"))
      ->excludes(movement->get_option("--turn"));
  movement->callback([o] {
    const ResultFolder folder(o->folder);
    if (o->mine) set_mine_pose(folder, "movement", o->options.shift, o->options.turn_deg);
    report_movement(folder, o->measure, o->options);
  });
}

}  // namespace muckpile
