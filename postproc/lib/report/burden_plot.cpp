// SPDX-License-Identifier: GPL-2.0-or-later
// Picture of the burden of each hole over height.
// Scope: see the header.
#include "report/burden_plot.h"

#include <algorithm>
#include <cmath>

#include "draw/curve_plot.h"
#include "draw/title.h"

namespace muckpile {
namespace {

constexpr size_t kColumns = 3;
constexpr double kWidth = 1200.0, kFrameWidth = 305.0, kFrameHeight = 260.0;  // [px]
constexpr double kLeft = 100.0, kGap = 75.0, kAbove = 40.0, kBelow = 75.0;    // of a frame [px]
constexpr double kTop = 42.0, kKeyTop = 62.0;                                 // [px]
constexpr double kFarthest = 2.2;  // of the plan: points beyond stand at the edge

enum Colours { kTooMuch = 0, kTooLittle = 1, kAsPlanned = 2, kNotJudged = 6, kPlan = 7 };

struct Ranges {
  AxisRange burden, height;
};

Ranges ranges_of(const std::vector<HoleBurdens>& holes, double plan) {
  double most = (kGreatestBurden + 0.1) * plan, low = 1e300, high = -1e300;
  for (const HoleBurdens& hole : holes) {
    for (const BurdenPoint& point : hole.points) {
      most = std::max(most, point.burden);
      low = std::min(low, point.height);
      high = std::max(high, point.height);
    }
  }
  if (plan > 0.0) most = std::min(most, kFarthest * plan);
  if (low > high) low = 0.0, high = 1.0;
  const double margin = std::max(0.05 * (high - low), 0.1);
  return {{0.0, most > 0.0 ? 1.04 * most : 1.0}, {low - margin, high + margin}};
}

PlotCurve band(double from, double to, const AxisRange& height, int colour) {
  return {"",
          CurveStyle::kBand,
          colour,
          {{from, height.low}, {to, height.low}, {to, height.high}, {from, height.high}}};
}

PlotCurve points_of(const HoleBurdens& hole, BurdenIs verdict, int colour, double edge) {
  PlotCurve curve{"", CurveStyle::kPoints, colour, {}};
  for (const BurdenPoint& point : hole.points) {
    if (point.verdict == verdict)
      curve.points.emplace_back(std::min(point.burden, edge), point.height);
  }
  return curve;
}

CurvePlot frame_of(const HoleBurdens& hole, double plan, const Ranges& ranges) {
  CurvePlot plot;
  plot.x = ranges.burden;
  plot.y = ranges.height;
  plot.x_label = "burden [m]";
  if (plan > 0.0) {
    plot.curves = {
        band(0.0, kLeastBurden * plan, ranges.height, kTooLittle),
        band(kGreatestBurden * plan, ranges.burden.high, ranges.height, kTooMuch),
        {"", CurveStyle::kDashed, kPlan, {{plan, ranges.height.low}, {plan, ranges.height.high}}}};
  }
  const double edge = ranges.burden.high;
  plot.curves.push_back(points_of(hole, BurdenIs::too_little, kTooLittle, edge));
  plot.curves.push_back(points_of(hole, BurdenIs::as_planned, kAsPlanned, edge));
  plot.curves.push_back(points_of(hole, BurdenIs::too_much, kTooMuch, edge));
  plot.curves.push_back(points_of(hole, BurdenIs::not_judged, kNotJudged, edge));
  return plot;
}

std::vector<PlotCurve> key_of(double plan) {
  if (!(plan > 0.0)) return {{"burden; no plan is told", CurveStyle::kPoints, kNotJudged, {}}};
  const auto bound = [&](const char* words, double share) {
    return words + spelled(share * plan) + " m";
  };
  return {{"of the plan, " + spelled(plan) + " m", CurveStyle::kDashed, kPlan, {}},
          {"as planned", CurveStyle::kPoints, kAsPlanned, {}},
          {bound("too little, below ", kLeastBurden), CurveStyle::kPoints, kTooLittle, {}},
          {bound("too much, above ", kGreatestBurden), CurveStyle::kPoints, kTooMuch, {}}};
}

}  // namespace

Canvas draw_burdens(const std::vector<HoleBurdens>& holes, double plan) {
  const Ranges ranges = ranges_of(holes, plan);
  const std::vector<PlotCurve> key = key_of(plan);
  const double right = kWidth - 0.3 * kLeft;
  const double top = kKeyTop + lay_out_key(key, kLeft, right, kKeyTop, nullptr);
  const double row_height = kAbove + kFrameHeight + kBelow;
  const size_t rows = (holes.size() + kColumns - 1) / kColumns;
  Canvas canvas(static_cast<int>(kWidth),
                static_cast<int>(std::lround(top + static_cast<double>(rows) * row_height)),
                kWhite);
  draw_title({kLeft, kTop}, "Burden of each hole along its charge", "", 28.0, canvas);
  lay_out_key(key, kLeft, right, kKeyTop, &canvas);
  for (size_t k = 0; k < holes.size(); ++k) {
    const double x = kLeft + static_cast<double>(k % kColumns) * (kFrameWidth + kGap);
    const double y = top + kAbove + static_cast<double>(k / kColumns) * row_height;
    CurvePlot plot = frame_of(holes[k], plan, ranges);
    if (k % kColumns == 0) plot.y_label = "height z [m]";
    draw_frame_of(plot, {x, y}, {x + kFrameWidth, y + kFrameHeight}, canvas);
    canvas.text({x + kFrameWidth, y - 8.0}, "hole " + holes[k].name, 20.0, kInk, Anchor::kRight);
  }
  return canvas;
}

}  // namespace muckpile
