// SPDX-License-Identifier: GPL-2.0-or-later
// muckpile-post: measures and draws what a run of Muckpile dumped.
// Scope: command line only; report/ does the work. Exit code 1 on faulty input, with one line of
// explanation; 3 where a report has no measures for the scene of a sound run; of compare, see
// compare_command.h.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <map>
#include <string>
#include <vector>

#include "calibrate_command.h"
#include "compare_command.h"
#include "damage_command.h"
#include "flyrock_command.h"
#include "measure_words.h"
#include "overlay_command.h"
#include "report/all_reports.h"
#include "report/not_measurable.h"
#include "report/plan_report.h"
#include "report/reports.h"
#include "sample_command.h"
#include "survey_command.h"
#include "sweep_command.h"

namespace {

using namespace muckpile;

const std::map<std::string, ColourBy> kColours{{"start_height", ColourBy::kStartHeight},
                                               {"start_depth", ColourBy::kStartDepth},
                                               {"fragment", ColourBy::kFragment},
                                               {"size", ColourBy::kSize},
                                               {"speed", ColourBy::kSpeed},
                                               {"displacement", ColourBy::kDisplacement},
                                               {"broken", ColourBy::kBroken}};

CLI::App* add_command(CLI::App& app, const char* name, const char* help, std::string& folder) {
  CLI::App* command = app.add_subcommand(name, help);
  command->add_option("folder", folder, "result folder of the run; it holds dump/")->required();
  return command;
}

void add_colour(CLI::App* command, std::string& colour) {
  std::vector<std::string> names;
  for (const auto& [name, by] : kColours) names.push_back(name);
  command->add_option("--colour", colour, "what the colours of blocks show")
      ->check(CLI::IsMember(names));
}

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

struct Options {
  std::string folder;
  MeasureOptions measure;
  FragmentOptions fragments;
  MovementOptions movement;
  WavesOptions waves;
  SectionOptions section;
  PictureOptions picture;
  std::string colour = "start_height";
  int every = 1;
  bool vtk = false;  // all: series too
};

void add_movement_command(CLI::App& app, Options& o) {
  CLI::App* movement =
      add_command(app, "movement",
                  "bench: movement.csv, movement.dxf, movement.png; where its parts went, by "
                  "level and distance from the face",
                  o.folder);
  add_measure(movement, o.measure);
  movement->add_option("--levels", o.movement.levels, "bands of height")->check(CLI::Range(1, 8));
  movement->add_option("--distances", o.movement.distances, "bands of distance from the face")
      ->check(CLI::Range(1, 20));
  movement
      ->add_option("--polygons", o.movement.polygons,
                   "polygons of ore to carry into the pile (CSV: polygon, x_m, y_m, z_low_m, "
                   "z_high_m): polygons.csv, polygons_moved.csv, polygons.dxf, polygons.png")
      ->check(CLI::ExistingFile);
  movement
      ->add_option(
          "--model", o.movement.model,
          "block model to carry into the pile (CSV: x_m, y_m, z_m of the middles, and what "
          "else it has): model_moved.csv")
      ->check(CLI::ExistingFile);
  movement->add_option("--shift", o.movement.shift,
                       "of polygons and model along x, y and z [m], before they are turned; "
                       "drawings and moved places are in their axes");
  movement->add_option("--turn", o.movement.turn_deg,
                       "of the shifted ones about the run's z axis, counter-clockwise seen from "
                       "above [deg]");
  movement->callback([&o] { report_movement(ResultFolder(o.folder), o.measure, o.movement); });
}

void add_waves_command(CLI::App& app, Options& o) {
  CLI::App* waves = add_command(app, "waves",
                                "runs with gauges: waves.csv, waves.png, ppv.csv, ppv.png; speeds "
                                "at gauges, peak velocity against scaled distance",
                                o.folder);
  waves->add_option("--gauges", o.waves.file, "file of fix muckpile/gauges in dump/");
  waves
      ->add_option("--until", o.waves.until,
                   "peaks and pictures end there [s] (default: the end of the run's first phase)")
      ->check(CLI::PositiveNumber);
  waves->callback([&o] { report_waves(ResultFolder(o.folder), o.waves); });
}

void add_pattern_commands(CLI::App& app, Options& o) {
  CLI::App* rows = add_command(app, "rows",
                               "bench with a hole table: rows.csv, face_velocity.csv, "
                               "face_velocity.png; what became of the rock of each hole and row",
                               o.folder);
  CLI::App* heights = add_command(app, "heights",
                                  "bench: heights.csv, heights.png; pile and bench from above, "
                                  "backbreak, toe left, volumes",
                                  o.folder);
  for (CLI::App* command : {rows, heights}) add_measure(command, o.measure);
  rows->callback([&o] { report_rows(ResultFolder(o.folder), o.measure); });
  heights->callback([&o] { report_heights(ResultFolder(o.folder), o.measure); });
}

void add_pile_commands(CLI::App& app, Options& o) {
  CLI::App* profile =
      add_command(app, "profile",
                  "bench: profile.csv, profile.png; throw, height, toe, swell, slope", o.folder);
  CLI::App* crater = add_command(
      app, "crater", "crater: crater.csv, crater.png; radius, depth, volume, ejecta", o.folder);
  CLI::App* heap = add_command(
      app, "heap", "heap: heap.csv, heap.png; angle of repose, height, toe, swell", o.folder);
  for (CLI::App* command : {profile, crater, heap}) {
    add_measure(command, o.measure);
    add_colour(command, o.colour);
    command->add_option("--y", o.section.y, "place of the section [m] (default: through a hole)");
  }
  add_movement_command(app, o);
  add_waves_command(app, o);
  add_pattern_commands(app, o);
  CLI::App* fragments =
      add_command(app, "fragments",
                  "size curves by sieve and volume, fits, Kuz-Ram, boulders: fragments.csv, "
                  "sieve.csv, fragments_list.csv, fragments.png",
                  o.folder);
  add_measure(fragments, o.measure);
  add_sizes(fragments, o.fragments);
  profile->callback([&o] {
    o.section.colour_by = kColours.at(o.colour);
    report_profile(ResultFolder(o.folder), o.measure, o.section);
  });
  crater->callback([&o] {
    o.section.colour_by = kColours.at(o.colour);
    report_crater(ResultFolder(o.folder), o.measure, o.section);
  });
  heap->callback([&o] {
    o.section.colour_by = kColours.at(o.colour);
    report_heap(ResultFolder(o.folder), o.measure, o.section);
  });
  fragments->callback([&o] { report_fragments(ResultFolder(o.folder), o.measure, o.fragments); });
}

void add_view(CLI::App* render, PictureOptions& picture) {
  render->add_option("--width", picture.width, "[px]")->check(CLI::Range(200, 8000));
  render->add_option("--height", picture.height, "[px]")->check(CLI::Range(200, 8000));
  render->add_option("--azimuth", picture.azimuth,
                     "of the eye, from the throw direction towards -y [deg]");
  render
      ->add_option("--elevation", picture.elevation,
                   "of the eye [deg] (default: 28, of a crater 45)")
      ->check(CLI::Range(1.0, 89.0));
  render->add_option("--zoom", picture.zoom, "the eye comes nearer by this factor")
      ->check(CLI::Range(0.05, 100.0));
  render->add_option("--focus", picture.focus,
                     "X Y Z in the middle of the picture [m] (default: of what it shows)");
}

void add_render_command(CLI::App& app, Options& o) {
  CLI::App* render =
      add_command(app, "render", "pile3d.png: the pile in three dimensions", o.folder);
  add_colour(render, o.colour);
  render->add_option("--colour-range", o.picture.colour_range,
                     "LOW HIGH of the colours, where one block would take them all (default: that "
                     "of the blocks)");
  render
      ->add_option("--frames", o.picture.frames,
                   "also this many pictures over the run, pile3d_0000.png ...")
      ->check(CLI::Range(0, 9999));
  CLI::Option* mirror = render
                            ->add_option("--mirror", o.picture.mirror,
                                         "mirror images of a bench to show on each side of it")
                            ->check(CLI::Range(0, 5));
  render
      ->add_option("--section", o.picture.section,
                   "cut away the rock between the eye and the plane at this y [m]")
      ->excludes(mirror);
  CLI::Option* film = render->add_option(
      "--mp4", o.picture.film, "film of all snapshots, or of those of --frames; needs ffmpeg");
  render->add_option("--fps", o.picture.frames_per_second, "pictures per second of the film")
      ->check(CLI::Range(1, 60))
      ->needs(film);
  add_view(render, o.picture);
  render->callback([&o] {
    o.picture.colour_by = kColours.at(o.colour);
    const auto& range = o.picture.colour_range;
    if (range && !((*range)[0] < (*range)[1]))
      throw CLI::ValidationError("--colour-range", "LOW must be below HIGH");
    report_picture(ResultFolder(o.folder), o.picture);
  });
}

void add_picture_commands(CLI::App& app, Options& o) {
  add_render_command(app, o);
  CLI::App* energy =
      add_command(app, "energy", "energy.png: where the energy is and went, over time", o.folder);
  energy->callback([&o] { report_energy(ResultFolder(o.folder)); });
  CLI::App* plan = app.add_subcommand("plan", "plan.png: the holes and when they fire");
  plan->add_option("table", o.folder, "hole table (CSV), or result folder with dump/holes.csv")
      ->required();
  plan->callback([&o] { report_plan(o.folder); });
  CLI::App* page = add_command(
      app, "report", "report.html: one page of the run, of what the other commands have left",
      o.folder);
  page->callback([&o] { report_page(ResultFolder(o.folder)); });
  CLI::App* series = add_command(
      app, "series", "vtk/blocks.pvd: all snapshots as polyhedra for ParaView", o.folder);
  series->add_option("--every", o.every, "write only every n-th snapshot and the last")
      ->check(CLI::PositiveNumber);
  series->callback([&o] { report_series(ResultFolder(o.folder), o.every); });
}

void say(const std::string& text) {
  std::printf("muckpile-post: %s\n", text.c_str());
  std::fflush(stdout);  // ahead of what comes on standard error
}

// A report that has no measures for the scene is no failure of the others.
void report_all(const std::string& path, bool vtk) {
  const ResultFolder folder(path);
  std::string refused;
  for (const std::string& name : reports_of(folder, vtk)) {
    say(name + " " + path);
    try {
      make_report(folder, name);
    } catch (const NotMeasurable& refusal) {
      std::fprintf(stderr, "muckpile-post: %s\n", refusal.what());
      refused += " " + name;
    }
  }
  say("results in " + path);
  std::fputs(summary_lines(folder).c_str(), stdout);
  for (const auto& picture : pictures_in(folder)) say("picture " + picture.string());
  say("page " + folder.file("report.html").string());
  if (!refused.empty()) {
    say("not measured:" + refused + "; the reason is above and in " +
        folder.file("summary.json").string());
  }
}

void add_all_command(CLI::App& app, Options& o) {
  CLI::App* all = add_command(
      app, "all", "what fits the scene of those above, and the key figures on the screen",
      o.folder);
  all->add_flag("--vtk", o.vtk, "also series, the snapshots as polyhedra for ParaView");
  all->callback([&o] { report_all(o.folder, o.vtk); });
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app(
      "Measures and draws the muck pile or crater of a run. Each command adds its keys to "
      "summary.json.");
  app.require_subcommand(1);
  app.option_defaults()->always_capture_default();
  Options options;
  add_pile_commands(app, options);
  add_picture_commands(app, options);
  add_all_command(app, options);
  int status = 0;
  add_calibrate_command(app, status);
  add_compare_command(app, status);
  add_damage_command(app);
  add_flyrock_command(app);
  add_overlay_command(app);
  add_survey_command(app);
  add_sample_command(app);
  add_sweep_command(app);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error);
  } catch (const NotMeasurable& refusal) {
    std::fprintf(stderr, "muckpile-post: %s\n", refusal.what());
    return kNotMeasurableExitCode;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "muckpile-post: %s\n", error.what());
    return 1;
  }
  return status;
}
