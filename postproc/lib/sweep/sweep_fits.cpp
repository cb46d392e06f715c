// SPDX-License-Identifier: GPL-2.0-or-later
// Which figures of a sweep are drawn and fitted, and the power laws of them.
// Scope: see the header.
#include "sweep/sweep_fits.h"

#include <algorithm>
#include <map>

#include "args/input_error.h"
#include "args/suggestion.h"

namespace muckpile {
namespace {

const std::vector<std::string>& figures_of_kind(const std::string& kind) {
  static const std::map<std::string, std::vector<std::string>> kOfKind{
      {"bench",
       {"throw_cg_m", "pile_height_m", "pile_toe_m", "face_velocity_mean_m_s", "swell_factor",
        "joints_broken_fraction"}},
      {"crater",
       {"crater_radius_m", "crater_depth_m", "crater_volume_m3", "apparent_crater_radius_m",
        "apparent_crater_depth_m", "ejecta_mass_kg"}},
      {"heap",
       {"repose_angle_deg", "front_slope_deg", "pile_height_m", "pile_toe_m", "swell_factor"}}};
  static const std::vector<std::string> kOther{"sieve_p50_m",       "sieve_p80_m",
                                               "fastest_block_m_s", "joints_broken_fraction",
                                               "wave_work_J",       "gas_work_J"};
  const auto found = kOfKind.find(kind);
  return found == kOfKind.end() ? kOther : found->second;
}

// Runs with the same values of all variables but one are a group.
std::vector<size_t> group_without(size_t variable, const std::vector<size_t>& place) {
  std::vector<size_t> others = place;
  others[variable] = 0;
  return others;
}

std::optional<SweepFit> fit_over(const Sweep& sweep, size_t variable, const std::string& figure) {
  const std::vector<double>& numbers = sweep.variables[variable].numbers;
  std::map<std::vector<size_t>, size_t> groups;
  std::vector<PowerPoint> points;
  SweepFit fit{figure, variable, {}, 0, 0, 0.0, 0.0};
  for (const SweepRun& run : sweep.runs) {
    if (!run.is_done()) continue;
    const double x = numbers[run.place[variable]];
    const auto y = run.figure(figure);
    if (!(x > 0.0) || !y || !(*y > 0.0)) {
      ++fit.left_out;
      continue;
    }
    const auto group = groups.emplace(group_without(variable, run.place), groups.size()).first;
    points.push_back({x, *y, group->second});
    fit.from = points.size() == 1 ? x : std::min(fit.from, x);
    fit.to = points.size() == 1 ? x : std::max(fit.to, x);
  }
  const auto law = fit_power_law(points);
  if (!law) return std::nullopt;
  fit.law = *law;
  fit.runs = points.size();
  return fit;
}

}  // namespace

std::vector<std::string> shown_figures(const Sweep& sweep, const std::vector<std::string>& asked) {
  const auto is_there = [&](const std::string& figure) {
    return std::ranges::find(sweep.figures, figure) != sweep.figures.end();
  };
  for (const std::string& figure : asked) {
    if (!is_there(figure))
      refuse("sweep",
             "no run has the figure '" + figure + "'" + did_you_mean(figure, sweep.figures));
  }
  if (!asked.empty()) return asked;
  std::vector<std::string> shown;
  std::ranges::copy_if(figures_of_kind(sweep.kind), std::back_inserter(shown), is_there);
  if (shown.empty())
    refuse("sweep", "no run has one of the figures " + joined(figures_of_kind(sweep.kind)) +
                        "; name others with --figures");
  return shown;
}

std::vector<SweepFit> fit_sweep(const Sweep& sweep, const std::vector<std::string>& figures) {
  std::vector<SweepFit> fits;
  for (const std::string& figure : figures) {
    for (size_t variable = 0; variable < sweep.variables.size(); ++variable) {
      const SweptVariable& over = sweep.variables[variable];
      if (over.numbers.empty() || over.name == "seed") continue;  // a seed is a name, no quantity
      if (const auto fit = fit_over(sweep, variable, figure)) fits.push_back(*fit);
    }
  }
  return fits;
}

}  // namespace muckpile
