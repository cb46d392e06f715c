// SPDX-License-Identifier: GPL-2.0-or-later
// muckpile-post: measures and draws what a run of Muckpile dumped.
// Scope: command line only; report/ does the work. Exit code 1 on faulty input, with one line of
// explanation; 3 where a report has no measures for the scene of a sound run; of compare, see
// compare_command.h.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <memory>
#include <string>

#include "all_command.h"
#include "calibrate_command.h"
#include "command_words.h"
#include "compare_command.h"
#include "damage_command.h"
#include "flyrock_command.h"
#include "fragments_command.h"
#include "large_pages.h"
#include "line_commands.h"
#include "movement_command.h"
#include "overlay_command.h"
#include "pile_commands.h"
#include "render_command.h"
#include "report/burden_report.h"
#include "report/not_measurable.h"
#include "report/plan_report.h"
#include "report/reports.h"
#include "run_id_command.h"
#include "sample_command.h"
#include "survey_command.h"
#include "sweep_command.h"

namespace {

using namespace muckpile;

struct Words {
  std::string folder;
  WavesOptions waves;
  int every = 1;
};

void add_waves_command(CLI::App& app) {
  const auto o = std::make_shared<Words>();
  CLI::App* waves = add_command(app, "waves",
                                "runs with gauges: waves.csv, waves.png, ppv.csv, ppv.png; speeds "
                                "at gauges, peak velocity against scaled distance",
                                o->folder);
  waves->add_option("--gauges", o->waves.file, "file of fix muckpile/gauges in dump/");
  waves
      ->add_option("--until", o->waves.until,
                   "peaks and pictures end there [s] (default: the end of the run's first phase)")
      ->check(above_zero());
  waves->callback([o] { report_waves(ResultFolder(o->folder), o->waves); });
}

void add_energy_command(CLI::App& app) {
  const auto o = std::make_shared<Words>();
  CLI::App* energy =
      add_command(app, "energy", "energy.png: where the energy is and went, over time", o->folder);
  energy->callback([o] { report_energy(ResultFolder(o->folder)); });
}

void add_momentum_command(CLI::App& app) {
  const auto o = std::make_shared<Words>();
  CLI::App* momentum = add_command(app, "momentum",
                                   "bench and crater with impulses: momentum.csv, momentum.png; "
                                   "what gave the rock its speed, by cause",
                                   o->folder);
  momentum->callback([o] { report_momentum(ResultFolder(o->folder)); });
}

void add_plan_command(CLI::App& app) {
  const auto o = std::make_shared<Words>();
  CLI::App* plan = app.add_subcommand("plan", "plan.png: the holes and when they fire");
  plan->add_option("table", o->folder, "hole table (CSV), or result folder with dump/holes.csv")
      ->required();
  plan->callback([o] { report_plan(o->folder); });
}

void add_burden_command(CLI::App& app) {
  const auto o = std::make_shared<Words>();
  CLI::App* burden = add_command(
      app, "burden",
      "burden.csv, burden.png: the burden of each hole along its charge, against the plan's",
      o->folder);
  burden->callback([o] { report_burden(ResultFolder(o->folder)); });
}

void add_page_command(CLI::App& app) {
  const auto o = std::make_shared<Words>();
  CLI::App* page = add_command(
      app, "report", "report.html: one page of the run, of what the other commands have left",
      o->folder);
  page->callback([o] { report_page(ResultFolder(o->folder)); });
}

void add_series_command(CLI::App& app) {
  const auto o = std::make_shared<Words>();
  CLI::App* series = add_command(
      app, "series", "vtk/blocks.pvd: all snapshots as polyhedra for ParaView", o->folder);
  series->add_option("--every", o->every, "write only every n-th snapshot and the last")
      ->check(above_zero());
  series->callback([o] { report_series(ResultFolder(o->folder), o->every); });
}

}  // namespace

int main(int argc, char** argv) {
  start_with_large_pages(argv);
  CLI::App app(
      "Measures and draws the muck pile or crater of a run. Each command adds its keys to "
      "summary.json.");
  app.require_subcommand(1);
  app.option_defaults()->always_capture_default();
  add_pile_commands(app);
  add_line_commands(app);
  add_movement_command(app);
  add_waves_command(app);
  add_fragments_command(app);
  add_render_command(app);
  add_energy_command(app);
  add_momentum_command(app);
  add_plan_command(app);
  add_burden_command(app);
  add_page_command(app);
  add_series_command(app);
  add_all_command(app);
  int status = 0;
  add_calibrate_command(app, status);
  add_compare_command(app, status);
  add_damage_command(app);
  add_flyrock_command(app);
  add_overlay_command(app);
  add_survey_command(app);
  add_run_id_command(app);
  add_sample_command(app);
  add_sweep_command(app);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error);
  } catch (const NotMeasurable& refusal) {
    tell(refusal);
    return kNotMeasurableExitCode;
  } catch (const std::exception& error) {
    tell(error);
    return 1;
  }
  return status;
}
