// SPDX-License-Identifier: GPL-2.0-or-later
// calibrate.png: each measured figure over each constant.
// Scope: see the header.
#include "calibrate/calibrate_plot.h"

namespace muckpile {
namespace {

using Eigen::Index;

enum Colours { kRuns = 0, kSurface = 1, kMeasure = 2, kEstimate = 3 };

PlotCurve runs_over(const PlottedConstant& constant, Index column, const PlottedFigure& figure) {
  PlotCurve curve{"runs, whose other constants vary", CurveStyle::kPoints, kRuns, {}};
  for (Index run = 0; run < figure.values.size(); ++run)
    curve.points.emplace_back(constant.scale.value_at(figure.places(run, column)),
                              figure.values[run]);
  return curve;
}

PlotCurve surface_over(const PlottedConstant& constant, Index column, const Target& target,
                       const Calibration& calibration) {
  constexpr int kParts = 40;
  PlotCurve curve{"surface, the others as fitted", CurveStyle::kLine, kSurface, {}};
  for (int k = 0; k <= kParts; ++k) {
    Eigen::VectorXd place = calibration.place;
    place[column] = -1.0 + 2.0 * k / kParts;
    curve.points.emplace_back(constant.scale.value_at(place[column]), target.surface.at(place));
  }
  return curve;
}

PlotCurve level(const std::string& label, CurveStyle style, double x_low, double x_high, double y) {
  return {label, style, kMeasure, {{x_low, y}, {x_high, y}}};
}

CurvePlot frame(const PlottedConstant& constant, Index column, const PlottedFigure& figure,
                const Target& target, const Calibration& calibration) {
  CurvePlot plot;
  plot.x_label = constant.label;
  plot.y_label = figure.label;
  plot.x_scale = Scale::kLogarithmic;
  const double low = constant.scale.value_at(-1.0), high = constant.scale.value_at(1.0);
  const double here = constant.scale.value_at(calibration.place[column]);
  plot.curves.push_back(runs_over(constant, column, figure));
  plot.curves.push_back(surface_over(constant, column, target, calibration));
  plot.curves.push_back(level("measured", CurveStyle::kLine, low, high, figure.measured));
  plot.curves.push_back(level("one standard deviation of the measure", CurveStyle::kDashed, low,
                              high, figure.measured - figure.uncertainty));
  plot.curves.push_back(
      level("", CurveStyle::kDashed, low, high, figure.measured + figure.uncertainty));
  plot.curves.push_back({"fitted",
                         CurveStyle::kPoints,
                         kEstimate,
                         {{here, target.surface.at(calibration.place)}},
                         {}});
  return plot;
}

}  // namespace

Panels plot_of_calibration(const std::vector<PlottedConstant>& constants,
                           const std::vector<PlottedFigure>& figures,
                           const std::vector<Target>& targets, const Calibration& calibration) {
  Panels panels;
  panels.title = "Constants fitted to measured figures";
  for (size_t k = 0; k < figures.size(); ++k)
    for (size_t i = 0; i < constants.size(); ++i)
      panels.plots.push_back(
          frame(constants[i], static_cast<Index>(i), figures[k], targets[k], calibration));
  return panels;
}

}  // namespace muckpile
