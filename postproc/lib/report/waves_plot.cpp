// SPDX-License-Identifier: GPL-2.0-or-later
// Pictures of what the gauges of a run felt.
// Scope: see the header.
#include "report/waves_plot.h"

#include <algorithm>
#include <cmath>

#include "draw/curve_plot.h"
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

}  // namespace

Canvas draw_waves(const std::vector<GaugePeak>& peaks) {
  constexpr double kRoom = 3.0;  // times that of the last peak
  const double until = kRoom * std::ranges::max(peaks, {}, &GaugePeak::time).time;
  CurvePlot plot;
  plot.title = "Speed at gauges";
  plot.x_label = "time [ms]";
  plot.y_label = "speed [m/s]";
  for (const GaugePeak& peak : chosen(peaks)) {
    PlotCurve curve{"gauge " + std::to_string(peak.gauge->number) + ", " + spelled(peak.distance) +
                        " m from the charge",
                    CurveStyle::kLine,
                    static_cast<int>(plot.curves.size()),
                    {}};
    for (size_t k = 0; k < peak.gauge->time.size() && peak.gauge->time[k] <= until; ++k)
      curve.points.emplace_back(1e3 * peak.gauge->time[k], peak.gauge->velocity[k].norm());
    plot.curves.push_back(std::move(curve));
  }
  return draw_curves(plot);
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
