// SPDX-License-Identifier: GPL-2.0-or-later
// Pictures of what the gauges of a run felt.
// Scope: see the header.
#include "report/waves_plot.h"

#include <algorithm>
#include <cmath>

#include "draw/panels.h"
#include "measure/blast_formulas.h"

namespace muckpile {
namespace {

// Gauges of one block draw one curve: of each block the nearest; of those the nearest, the
// farthest, and others at even steps in the order of distance.
std::vector<GaugePeak> chosen(std::vector<GaugePeak> peaks) {
  std::ranges::sort(peaks, {}, &GaugePeak::distance);
  std::vector<GaugePeak> all;
  for (const GaugePeak& peak : peaks) {
    const auto same = [&](const GaugePeak& other) {
      return other.gauge->block == peak.gauge->block;
    };
    if (std::ranges::none_of(all, same)) all.push_back(peak);
  }
  if (all.size() <= kCurveColours) return all;
  std::vector<GaugePeak> few;
  for (size_t k = 0; k < kCurveColours; ++k)
    few.push_back(all[k * (all.size() - 1) / (kCurveColours - 1)]);
  return few;
}

PlotCurve along(const std::string& label, CurveStyle style, int colour, const AxisRange& x,
                const auto& of) {
  constexpr int kPoints = 60;
  PlotCurve curve{label, style, colour, {}};
  for (int k = 0; k <= kPoints; ++k) {
    const double at = x.low * std::pow(x.high / x.low, static_cast<double>(k) / kPoints);
    curve.points.emplace_back(at, of(at));
  }
  return curve;
}

std::string law_of(const PowerFit& fit) {
  const double reach = 0.5 * (fit.exponent_range.high - fit.exponent_range.low);
  return "fit: " + spelled(fit.factor) + " (R/√W)^-n, n = " + spelled(fit.exponent) + " ± " +
         spelled(reach, 2);
}

// Until a time [s].
PlotCurve history_of(const GaugePeak& peak, int colour, double until,
                     double (*of)(const GaugeHistory&, size_t)) {
  const GaugeHistory& gauge = *peak.gauge;
  PlotCurve curve{"gauge " + std::to_string(gauge.number) + ", " + spelled(peak.distance) +
                      " m from the charge",
                  CurveStyle::kLine,
                  colour,
                  {}};
  for (size_t k = 0; k < gauge.time.size() && gauge.time[k] <= until; ++k)
    curve.points.emplace_back(1e3 * gauge.time[k], of(gauge, k));
  return curve;
}

}  // namespace

Canvas draw_waves(const std::vector<GaugePeak>& peaks) {
  constexpr double kRoom = 3.0;  // times that of the last peak
  constexpr double kMegapascal = 1e6;
  const double until = kRoom * std::ranges::max(peaks, {}, &GaugePeak::time).time;
  using Of = double (*)(const GaugeHistory&, size_t);
  const struct {
    const char *title, *label;
    Of of;
  } frames[] = {{"speed", "speed [m/s]",
                 [](const GaugeHistory& g, size_t k) { return g.velocity[k].norm(); }},
                {"mean pressure", "pressure [MPa]",
                 [](const GaugeHistory& g, size_t k) { return g.pressure[k] / kMegapascal; }},
                {"largest principal stress, compression positive", "s1 [MPa]",
                 [](const GaugeHistory& g, size_t k) { return g.principal[k].x() / kMegapascal; }},
                {"least principal stress, below 0 tension", "s3 [MPa]",
                 [](const GaugeHistory& g, size_t k) { return g.principal[k].z() / kMegapascal; }}};
  const std::vector<GaugePeak> shown = chosen(peaks);
  Panels panels;
  panels.title = "Speed and stress at gauges";
  for (const auto& frame : frames) {
    CurvePlot plot;
    plot.title = frame.title;
    plot.x_label = "time [ms]";
    plot.y_label = frame.label;
    for (const GaugePeak& peak : shown)
      plot.curves.push_back(
          history_of(peak, static_cast<int>(plot.curves.size()), until, frame.of));
    panels.plots.push_back(std::move(plot));
  }
  return draw_panels(panels);
}

Canvas draw_peaks(const std::vector<GaugePeak>& peaks, const std::optional<PowerFit>& fit,
                  double charge) {
  CurvePlot plot;
  plot.title = "Peak particle velocity, " + spelled(charge) + " kg within 8 ms";
  plot.x_label = "scaled distance R/√W [m/kg^0.5]";
  plot.y_label = "peak particle velocity [m/s]";
  plot.x_scale = plot.y_scale = Scale::kLogarithmic;
  PlotCurve points{"gauges", CurveStyle::kPoints, 0, {}};
  AxisRange x{1e300, 0.0};
  for (const GaugePeak& peak : peaks) {
    if (peak.speed <= 0.0 || peak.scaled <= 0.0) continue;
    points.points.emplace_back(peak.scaled, peak.speed);
    x = {std::min(x.low, peak.scaled), std::max(x.high, peak.scaled)};
  }
  if (fit) {
    plot.curves.push_back(
        along(law_of(*fit), CurveStyle::kLine, 0, x, [&](double at) { return fit->at(at); }));
    plot.curves.push_back(along("95 % band for a further gauge", CurveStyle::kDashed, 6, x,
                                [&](double at) { return fit->band(at).low; }));
    plot.curves.push_back(
        along("", CurveStyle::kDashed, 6, x, [&](double at) { return fit->band(at).high; }));
  }
  if (x.high > 0.0)
    plot.curves.push_back(along("a formula: Bureau of Mines, conservative", CurveStyle::kDashed, 1,
                                x, [](double at) { return bureau_of_mines_ppv(at); }));
  plot.curves.push_back(std::move(points));
  return draw_curves(plot);
}

}  // namespace muckpile
