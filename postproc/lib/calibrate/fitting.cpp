// SPDX-License-Identifier: GPL-2.0-or-later
// A calibration with all that it is made of.
// Scope: see the header.
#include "calibrate/fitting.h"

#include <algorithm>
#include <cmath>

#include "args/input_error.h"
#include "args/suggestion.h"
#include "sweep/sweep_plot.h"

namespace muckpile {
namespace {

using Eigen::Index;

constexpr size_t kMostConstants = 6;

PlottedConstant constant_of(const SweptVariable& variable) {
  const std::string who = "calibrate: constant '" + variable.name + "'";
  if (variable.name == "seed")
    refuse("calibrate", "the sweep varies the seed alone; sweep uncertain constants");
  if (variable.values.size() < 2)
    refuse(who, "must be swept over two values at least, got '" + joined(variable.values) + "'");
  if (variable.numbers.empty() || std::ranges::min(variable.numbers) <= 0.0)
    refuse(who, "must be swept over positive numbers, as its logarithm counts, got '" +
                    joined(variable.values) + "'");
  return {variable.label(), log_scale(variable.numbers)};
}

std::vector<PlottedConstant> constants_of(const Sweep& sweep) {
  if (sweep.variables.size() > kMostConstants)
    refuse("calibrate", "fits " + std::to_string(kMostConstants) + " constants at most, got " +
                            std::to_string(sweep.variables.size()));
  std::vector<PlottedConstant> all;
  for (const SweptVariable& variable : sweep.variables) all.push_back(constant_of(variable));
  return all;
}

// A quadratic surface needs three values of each constant, and three runs to spare for its scatter.
SurfaceOrder order_for(const std::string& word, const Sweep& sweep) {
  if (word == "linear") return SurfaceOrder::kLinear;
  if (word == "quadratic") return SurfaceOrder::kQuadratic;
  constexpr size_t kValues = 3, kSpare = 3;
  const auto done = static_cast<size_t>(std::ranges::count_if(sweep.runs, &SweepRun::is_done));
  const bool enough = std::ranges::all_of(
      sweep.variables, [](const SweptVariable& v) { return v.values.size() >= kValues; });
  return enough && done >= terms_of(SurfaceOrder::kQuadratic, sweep.variables.size()) + kSpare
             ? SurfaceOrder::kQuadratic
             : SurfaceOrder::kLinear;
}

PlottedFigure figure_of(const MeasuredFigure& measured, const Sweep& sweep,
                        const std::vector<PlottedConstant>& constants) {
  if (std::ranges::find(sweep.figures, measured.key) == sweep.figures.end())
    refuse("calibrate", "no run of the sweep has the figure '" + measured.key + "'" +
                            did_you_mean(measured.key, sweep.figures));
  std::vector<const SweepRun*> runs;
  for (const SweepRun& run : sweep.runs)
    if (run.is_done() && run.figure(measured.key)) runs.push_back(&run);
  PlottedFigure figure{name_of_figure(measured.key), measured.value, measured.uncertainty,
                       Eigen::MatrixXd(runs.size(), constants.size()),
                       Eigen::VectorXd(runs.size())};
  for (size_t k = 0; k < runs.size(); ++k) {
    const auto row = static_cast<Index>(k);
    figure.values[row] = *runs[k]->figure(measured.key);
    for (size_t i = 0; i < constants.size(); ++i)
      figure.places(row, static_cast<Index>(i)) =
          constants[i].scale.place_of(sweep.variables[i].numbers[runs[k]->place[i]]);
  }
  return figure;
}

}  // namespace

Fitting fitted(const FitOptions& options) {
  Fitting f{read_sweep(options.sweep), read_measured(options.measured), {}, {}, {}, {}, {}};
  f.constants = constants_of(f.sweep);
  f.order = order_for(options.order, f.sweep);
  for (const MeasuredFigure& measured : f.measured) {
    f.figures.push_back(figure_of(measured, f.sweep, f.constants));
    const PlottedFigure& figure = f.figures.back();
    const ResponseSurface surface(f.order, figure.places, figure.values,
                                  "calibrate: figure '" + measured.key + "'");
    f.targets.push_back(
        {measured.value, std::hypot(measured.uncertainty, surface.scatter()), surface});
  }
  f.result = calibrate(f.targets, f.constants.size());
  return f;
}

double estimate(const Fitting& f, size_t i) {
  return f.constants[i].scale.value_at(f.result.place[static_cast<Index>(i)]);
}

double error_ln(const Fitting& f, size_t i) {
  const auto k = static_cast<Index>(i);
  return f.constants[i].scale.half * std::sqrt(f.result.covariance(k, k));
}

double told(const Fitting& f, size_t i) {
  double share = 0.0;
  for (const Direction& each : f.result.directions) {
    const double part = each.way[static_cast<Index>(i)];
    if (each.is_resolved()) share += part * part;
  }
  return share;
}

}  // namespace muckpile
