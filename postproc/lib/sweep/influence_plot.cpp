// SPDX-License-Identifier: GPL-2.0-or-later
// sweep.png of a sweep over sampled ranges.
// Scope: see the header.
#include "sweep/influence_plot.h"

#include <algorithm>
#include <cstdio>

#include "args/suggestion.h"
#include "sweep/spread.h"
#include "sweep/sweep_plot.h"

namespace muckpile {
namespace {

constexpr size_t kNamed = 3;  // variables in a frame's title

std::string plain(std::string name) {
  std::ranges::replace(name, '_', ' ');
  return name;
}

// "burden -0.81, energy share 0.35".
std::string words_for(const Sweep& sweep, const FigureInfluences& found) {
  std::vector<std::string> words;
  for (const Influence& one : found.of) {
    if (words.size() == kNamed || !one.correlation) break;
    char number[16];
    std::snprintf(number, sizeof number, "%.2f", *one.correlation);
    words.push_back(plain(sweep.variables[one.variable].name) + " " + number);
  }
  return joined(words);
}

PlotCurve level(const std::string& label, double height, double from, double to, int colour) {
  return {label, CurveStyle::kDashed, colour, {Vec2(from, height), Vec2(to, height)}, {}};
}

CurvePlot plot_of(const Sweep& sweep, const FigureInfluences& found) {
  const SweptVariable& over = sweep.variables[found.of.front().variable];
  PlotCurve runs{"runs", CurveStyle::kPoints, 0, {}, {}};
  std::vector<double> values;
  for (const SweepRun& run : sweep.runs) {
    const auto value = run.is_done() ? run.figure(found.figure) : std::nullopt;
    if (!value) continue;
    runs.points.emplace_back(over.numbers[run.place[found.of.front().variable]], *value);
    values.push_back(*value);
  }
  CurvePlot plot;
  plot.title = words_for(sweep, found);
  plot.x_label = over.label();
  plot.y_label = name_of_figure(found.figure);
  plot.curves = {runs};
  if (values.empty()) return plot;
  const auto [least, most] = std::ranges::minmax(over.numbers);
  const Spread spread = spread_of(values);
  plot.curves.push_back(level("P10", spread.p10, least, most, 1));
  plot.curves.push_back(level("P50", spread.p50, least, most, 2));
  plot.curves.push_back(level("P90", spread.p90, least, most, 3));
  return plot;
}

}  // namespace

Panels plot_of_samples(const Sweep& sweep, const std::vector<FigureInfluences>& influences) {
  Panels panels;
  panels.title = sweep.kind + ": " + std::to_string(sweep.runs.size()) + " runs over ranges";
  panels.warning = warning_of(sweep);
  panels.remark = "above each frame: rank correlations, the largest first";
  for (const FigureInfluences& found : influences) {
    if (!found.of.empty()) panels.plots.push_back(plot_of(sweep, found));
  }
  return panels;
}

}  // namespace muckpile
