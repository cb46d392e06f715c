// SPDX-License-Identifier: GPL-2.0-or-later
// A plot of curves and points with axes, a title and a key.
// Scope: see the header.
#include "draw/curve_plot.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "draw/text.h"
#include "draw/title.h"

namespace muckpile {
namespace {

constexpr int kWidth = 1200;
constexpr double kLeft = 110.0, kRight = 30.0, kBelow = 85.0, kPlotHeight = 620.0;  // [px]
constexpr double kTitleSize = 28.0, kKeySize = 20.0, kKeyLine = 30.0, kKeyStroke = 40.0;
constexpr double kTop = 66.0;  // of the key [px]
constexpr double kThickness = 3.0, kDash = 9.0, kPointSize = 5.0;
constexpr double kThinLine = 1.2, kBandOpacity = 0.25;
constexpr double kBarThickness = 1.6, kBarCap = 5.0;

AxisRange range_of(const CurvePlot& plot, int axis, Scale scale) {
  double low = 1e300, high = -1e300;
  const auto take = [&](const Vec2& p) {
    low = std::min(low, p[axis]);
    high = std::max(high, p[axis]);
  };
  for (const PlotCurve& curve : plot.curves) {
    for (const Vec2& p : curve.points) take(p);
    for (const PlotBar& bar : curve.bars) {
      take({bar.x, bar.low});
      take({bar.x, bar.high});
    }
  }
  if (low > high) return {1.0, 2.0};
  if (scale == Scale::kLogarithmic) return {low / 1.15, high * 1.15};
  const double margin = high > low ? 0.04 * (high - low) : 0.5 * std::max(std::abs(high), 1.0);
  return {low - margin, high + margin};
}

AxisRange x_range_of(const CurvePlot& plot) {
  if (plot.x) return *plot.x;
  if (!plot.x_words.empty()) return {0.5, static_cast<double>(plot.x_words.size()) + 0.5};
  return range_of(plot, 0, plot.x_scale);
}

bool is_inside(const Vec2& p, const AxisRange& x, const AxisRange& y) {
  return p.x() >= x.low && p.x() <= x.high && p.y() >= y.low && p.y() <= y.high;
}

// Of the same area, so that none looks heavier than the others.
void draw_marker(Canvas& canvas, const Vec2& at, int corners, Colour colour) {
  const double sector = 2.0 * M_PI / corners;
  const double radius = kPointSize * std::sqrt(sector / std::sin(sector));
  std::vector<Vec2> polygon;
  for (int k = 0; k < corners; ++k) {
    const double angle = sector * k - 0.5 * M_PI;  // the first corner is the highest
    polygon.push_back(at + radius * Vec2(std::cos(angle), std::sin(angle)));
  }
  canvas.fill(polygon, colour);
}

void draw_markers(Canvas& canvas, const std::vector<Vec2>& points, int curve) {
  for (const Vec2& p : points)
    draw_marker(canvas, p, marker_corners(curve), colour_of_curve(curve));
}

void draw_stroke(Canvas& canvas, const std::vector<Vec2>& points, const PlotCurve& curve) {
  const Colour colour = colour_of_curve(curve.colour);
  switch (curve.style) {
    case CurveStyle::kLine:
      canvas.polyline(points, kThickness, colour);
      break;
    case CurveStyle::kThin:
      canvas.polyline(points, kThinLine, colour);
      break;
    case CurveStyle::kBand:
      canvas.fill(points, colour, kBandOpacity);
      break;
    case CurveStyle::kDashed:
      canvas.dashes(points, kThickness, kDash, colour);
      break;
    case CurveStyle::kPoints:
      draw_markers(canvas, points, curve.colour);
      break;
    case CurveStyle::kLineAndPoints:
      canvas.polyline(points, kThickness, colour);
      draw_markers(canvas, points, curve.colour);
      break;
  }
}

void draw_bar(Canvas& canvas, const Axes& axes, const PlotBar& bar, Colour colour) {
  const Vec2 low = axes.place(bar.x, bar.low), high = axes.place(bar.x, bar.high);
  const Vec2 cap(kBarCap, 0.0);
  canvas.line(low, high, kBarThickness, colour);
  canvas.line(low - cap, low + cap, kBarThickness, colour);
  canvas.line(high - cap, high + cap, kBarThickness, colour);
}

void draw_curve(Canvas& canvas, const Axes& axes, const PlotCurve& curve, const AxisRange& x,
                const AxisRange& y) {
  if (curve.style == CurveStyle::kBand)
    return draw_stroke(canvas, axes.places(curve.points), curve);
  std::vector<Vec2> part;
  for (const Vec2& p : curve.points) {
    if (is_inside(p, x, y)) {
      part.push_back(axes.place(p.x(), p.y()));
      continue;
    }
    draw_stroke(canvas, part, curve);
    part.clear();
  }
  draw_stroke(canvas, part, curve);
  for (const PlotBar& bar : curve.bars) draw_bar(canvas, axes, bar, colour_of_curve(curve.colour));
}

// The range that has more pixels to a metre, about its middle.
void widen_to_one_scale(AxisRange& x, AxisRange& y, const Vec2& size) {
  const double metres = std::max((x.high - x.low) / size.x(), (y.high - y.low) / size.y());
  const auto widen = [metres](AxisRange& range, double pixels) {
    const double more = 0.5 * (metres * pixels - (range.high - range.low));
    range = {range.low - more, range.high + more};
  };
  widen(x, size.x());
  widen(y, size.y());
}

}  // namespace

Colour colour_of_curve(int number) {
  constexpr std::array<Colour, kCurveColours> kColours{{{0.00F, 0.45F, 0.70F},
                                                        {0.84F, 0.37F, 0.00F},
                                                        {0.00F, 0.62F, 0.45F},
                                                        {0.80F, 0.47F, 0.65F},
                                                        {0.90F, 0.62F, 0.00F},
                                                        {0.34F, 0.71F, 0.91F},
                                                        {0.45F, 0.45F, 0.45F},
                                                        {0.13F, 0.14F, 0.16F}}};
  return kColours[static_cast<size_t>(number) % kColours.size()];
}

int marker_corners(int number) {
  constexpr std::array kCorners{16, 4, 3};  // disc, diamond, triangle
  return kCorners[static_cast<size_t>(number) / kCurveColours % kCorners.size()];
}

double lay_out_key(const std::vector<PlotCurve>& curves, double left, double right, double top,
                   Canvas* canvas) {
  double x = left, y = top + kKeySize;
  for (const PlotCurve& curve : curves) {
    if (curve.label.empty()) continue;
    const double width = kKeyStroke + 40.0 + text_mask(curve.label, kKeySize, 0.0).advance.x();
    if (x > left && x + width > right) {
      x = left;
      y += kKeyLine;
    }
    if (canvas != nullptr) {
      const double middle = y - 0.35 * kKeySize;
      if (curve.style == CurveStyle::kPoints) {
        draw_stroke(*canvas, {{x + 0.5 * kKeyStroke, middle}}, curve);
      } else if (curve.style == CurveStyle::kBand) {
        const Vec2 half(0.0, 0.4 * kKeySize), from(x, middle), to(x + kKeyStroke, middle);
        draw_stroke(*canvas, {from - half, to - half, to + half, from + half}, curve);
      } else {
        draw_stroke(*canvas, {{x, middle}, {x + kKeyStroke, middle}}, curve);
      }
      canvas->text({x + kKeyStroke + 8.0, y}, curve.label, kKeySize, kInk);
    }
    x += width;
  }
  return y + 0.7 * kKeyLine - top;
}

void draw_frame_of(const CurvePlot& plot, const Vec2& upper_left, const Vec2& lower_right,
                   Canvas& canvas) {
  AxisRange x = x_range_of(plot), y = plot.y.value_or(range_of(plot, 1, plot.y_scale));
  if (plot.one_scale) widen_to_one_scale(x, y, lower_right - upper_left);
  Axes axes(upper_left, lower_right, x, y, plot.x_scale, plot.y_scale);
  axes.name_x(plot.x_words);
  axes.draw_grid(canvas);
  for (const PlotCurve& curve : plot.curves) draw_curve(canvas, axes, curve, x, y);
  axes.draw_frame(canvas, plot.x_label, plot.y_label);
}

Canvas draw_curves(const CurvePlot& plot) {
  const double right = kWidth - kRight;
  const double top = kTop + lay_out_key(plot.curves, kLeft, right, kTop, nullptr);
  Canvas canvas(kWidth, static_cast<int>(std::lround(top + kPlotHeight + kBelow + plot.room_below)),
                kWhite);
  draw_frame_of(plot, {kLeft, top}, {right, top + kPlotHeight}, canvas);
  draw_title({kLeft, 42.0}, plot.title, plot.warning, kTitleSize, canvas);
  lay_out_key(plot.curves, kLeft, right, kTop, &canvas);
  return canvas;
}

}  // namespace muckpile
