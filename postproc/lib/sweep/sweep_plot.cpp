// SPDX-License-Identifier: GPL-2.0-or-later
// sweep.png: figures of a sweep over its first variable.
// Scope: see the header.
#include "sweep/sweep_plot.h"

#include <algorithm>
#include <cctype>
#include <map>

#include "args/suggestion.h"
#include "page/figures_table.h"
#include "sweep/spread.h"
#include "sweep/sweep_tables.h"

namespace muckpile {
namespace {

// Where a run stands on the first variable's axis: its number, or the place of its word from 1 on.
double across(const Sweep& sweep, const SweepRun& run) {
  const SweptVariable& variable = sweep.variables.front();
  const size_t place = run.place.front();
  return variable.numbers.empty() ? static_cast<double>(place + 1) : variable.numbers[place];
}

// All of one combination of the variables but the first, in the order of the sweep.
std::vector<PlotCurve> curves_of(const Sweep& sweep, const std::string& figure) {
  std::vector<PlotCurve> curves;
  std::map<std::vector<size_t>, size_t> number;
  for (const auto& runs : combinations_of(sweep)) {
    const SweepRun& first = *runs.front();
    const auto [found, is_new] =
        number.emplace(std::vector(first.place.begin() + 1, first.place.end()), curves.size());
    if (is_new) {
      curves.push_back({sweep.words_for(first, 1),
                        CurveStyle::kLineAndPoints,
                        static_cast<int>(curves.size()),
                        {},
                        {}});
    }
    std::vector<double> values;
    for (const SweepRun* run : runs) {
      if (const auto value = run->figure(figure)) values.push_back(*value);
    }
    if (values.empty()) continue;
    const Spread spread = spread_of(values);
    PlotCurve& curve = curves[found->second];
    curve.points.emplace_back(across(sweep, first), spread.mean);
    if (spread.count > 1)
      curve.bars.push_back({curve.points.back().x(), spread.least, spread.largest});
  }
  for (PlotCurve& curve : curves)
    std::ranges::sort(curve.points, {}, [](const Vec2& p) { return p.x(); });
  return curves;
}

// "burden: exponent -1.2 +- 0.1".
std::string words_for_fits(const Sweep& sweep, const std::string& figure,
                           const std::vector<SweepFit>& fits) {
  std::vector<std::string> words;
  for (const SweepFit& fit : fits) {
    if (fit.figure != figure) continue;
    std::string name = sweep.variables[fit.variable].name;
    std::ranges::replace(name, '_', ' ');
    words.push_back(name + "^(" + spelled(fit.law.exponent) +
                    (fit.law.error ? " ± " + spelled(*fit.law.error, 2) : "") + ")");
  }
  return words.empty() ? "" : "~ " + joined(words, " ");
}

std::string warning_of(const Sweep& sweep) {
  std::vector<std::string> words;
  const auto count = [&](const auto& is_one, const std::string& what) {
    const auto number = std::ranges::count_if(sweep.runs, is_one);
    if (number > 0) words.push_back(std::to_string(number) + " " + what);
  };
  count([](const SweepRun& run) { return !run.is_done(); }, "MISSING");
  count([](const SweepRun& run) { return run.figure("still") == 0.0; }, "STILL MOVING");
  return joined(words);
}

}  // namespace

std::string name_of_figure(const std::string& figure) {
  const KeyAndUnit split = split_unit(figure);
  std::string name = split.name;
  name.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(name.front())));
  for (const NamedKey& known : key_figures()) {
    if (figure == known.key) name = known.name;
  }
  // Shares are drawn as they stand in the tables.
  return split.unit.empty() || split.unit == "%" ? name : name + " [" + split.unit + "]";
}

Panels plot_of_sweep(const Sweep& sweep, const std::vector<std::string>& figures,
                     const std::vector<SweepFit>& fits) {
  Panels panels;
  panels.title = sweep.kind + ": " + std::to_string(sweep.runs.size()) + " runs";
  panels.warning = warning_of(sweep);
  if (sweep.has_seeds) panels.remark = "means over the seeds; bars: least and largest";
  const SweptVariable& first = sweep.variables.front();
  for (const std::string& figure : figures) {
    CurvePlot plot;
    plot.title = words_for_fits(sweep, figure, fits);
    plot.x_label = first.label();
    plot.y_label = name_of_figure(figure);
    plot.curves = curves_of(sweep, figure);
    if (first.numbers.empty()) plot.x_words = first.values;
    panels.plots.push_back(plot);
  }
  return panels;
}

}  // namespace muckpile
