// SPDX-License-Identifier: GPL-2.0-or-later
// Picture of what gave parts of the rock their speed, over time.
// Scope: see the header.
#include "report/momentum_plot.h"

#include <array>
#include <utility>

#include "draw/panels.h"

namespace muckpile {
namespace {

constexpr std::array<const char*, kImpulseParts> kLabels = {
    "before the blast",       "wave",     "gas in the hole", "gas in joints",
    "other forces of joints", "contacts", "weight"};

PlotCurve curve_of(const BudgetCurves& of, const std::string& label, CurveStyle style, int colour,
                   const auto& value) {
  PlotCurve curve{label, style, colour, {}};
  for (size_t k = 0; k < of.time.size(); ++k)
    if (of.time[k] > 0.0) curve.points.emplace_back(1e3 * of.time[k], value(of.budgets[k]));
  return curve;
}

}  // namespace

Canvas draw_momentum(const std::vector<BudgetCurves>& curves) {
  Panels panels;
  panels.title = "What gave the rock its speed";
  for (const BudgetCurves& of : curves) {
    CurvePlot plot;
    plot.title = of.title;
    plot.x_label = "time [ms]";
    plot.y_label = "impulse over mass [m/s]";
    plot.x_scale = Scale::kLogarithmic;
    plot.curves.push_back(curve_of(of, "speed", CurveStyle::kDashed, 7,
                                   [](const Budget& budget) { return budget.speed; }));
    for (size_t k = 1; k < kImpulseParts; ++k)
      plot.curves.push_back(curve_of(of, kLabels[k], CurveStyle::kLine, static_cast<int>(k) - 1,
                                     [k](const Budget& budget) { return budget.by_cause[k]; }));
    panels.plots.push_back(std::move(plot));
  }
  return draw_panels(panels);
}

}  // namespace muckpile
