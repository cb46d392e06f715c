// SPDX-License-Identifier: GPL-2.0-or-later
// Sub-command sweep: tables and plots of the runs of ./muckpile sweep.
// Scope: see the header.
#include "sweep/sweep_report.h"

#include "draw/png_file.h"
#include "sweep/influence.h"
#include "sweep/influence_plot.h"
#include "sweep/overlay_report.h"
#include "sweep/sweep_fits.h"
#include "sweep/sweep_plot.h"
#include "sweep/sweep_tables.h"

namespace muckpile {
namespace {

// The surface of the pile in all runs that have measured one, three at least.
std::vector<std::filesystem::path> overlay_profiles(const Sweep& sweep) {
  constexpr size_t kFewest = 3;
  OverlayOptions options{{}, "profile.csv", {"pile_mean_m"}, sweep.folder.string()};
  for (const SweepRun& run : sweep.runs) {
    const std::filesystem::path folder = sweep.folder / run.folder;
    if (run.is_done() && std::filesystem::exists(folder / options.table))
      options.runs.push_back(folder.string());
  }
  return options.runs.size() < kFewest ? std::vector<std::filesystem::path>{}
                                       : report_overlay(options);
}

// What a sweep of the other kind, or with more runs, has left in the folder.
void remove_older(const Sweep& sweep, const std::vector<const char*>& names) {
  for (const char* name : names) std::filesystem::remove(sweep.folder / name);
}

// What a sweep has beside sweep.csv, sweep_mean.csv and sweep.png.
std::vector<std::filesystem::path> report_samples(const Sweep& sweep,
                                                  const std::vector<std::string>& shown) {
  remove_older(sweep, {"sweep_fit.csv", "overlay_profile.csv", "overlay_profile.png"});
  const std::vector<FigureInfluences> influences = influences_of(sweep, shown);
  write_influence_table(sweep, influences);
  write_png(draw_panels(plot_of_samples(sweep, influences)), sweep.folder / "sweep.png");
  std::vector<std::filesystem::path> written{sweep.folder / "sweep_influence.csv"};
  for (const auto& file : overlay_profiles(sweep)) written.push_back(file);
  return written;
}

std::vector<std::filesystem::path> report_values(const Sweep& sweep,
                                                 const std::vector<std::string>& shown) {
  remove_older(sweep, {"sweep_fit.csv", "sweep_influence.csv"});
  const std::vector<SweepFit> fits = fit_sweep(sweep, shown);
  write_png(draw_panels(plot_of_sweep(sweep, shown, fits)), sweep.folder / "sweep.png");
  if (fits.empty()) return {};
  write_fit_table(sweep, fits);
  return {sweep.folder / "sweep_fit.csv"};
}

}  // namespace

std::vector<std::filesystem::path> report_sweep(const std::filesystem::path& folder,
                                                const std::vector<std::string>& figures) {
  const Sweep sweep = read_sweep(folder);
  const std::vector<std::string> shown = shown_figures(sweep, figures);
  write_runs_table(sweep);
  write_spread_table(sweep);
  const auto more = sweep.is_sampled ? report_samples(sweep, shown) : report_values(sweep, shown);
  std::vector<std::filesystem::path> written{folder / "sweep.csv", folder / "sweep_mean.csv"};
  written.insert(written.end(), more.begin(), more.end());
  written.push_back(folder / "sweep.png");
  return written;
}

}  // namespace muckpile
