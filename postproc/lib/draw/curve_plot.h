// SPDX-License-Identifier: GPL-2.0-or-later
// A plot of curves and points with axes, a title and a key.
// Scope: one frame, which panels.h puts beside others; the ranges follow from the data unless they
// are given.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "draw/axes.h"
#include "draw/canvas.h"

namespace muckpile {

// kThin: one of many, such as each run behind a mean. kBand: the points go around an area, which is
// filled palely; it knows no range of the plot.
enum class CurveStyle { kLine, kThin, kDashed, kPoints, kLineAndPoints, kBand };

struct PlotBar {
  double x, low, high;
};

struct PlotCurve {
  std::string label;  // in the key; an empty one is left out of it
  CurveStyle style = CurveStyle::kLine;
  int colour = 0;  // number of the curve: its colour and, for points, its marker
  std::vector<Vec2> points;
  std::vector<PlotBar> bars{};  // scatter, say, of the points
};

struct CurvePlot {
  std::string title, x_label, y_label;
  Scale x_scale = Scale::kStraight, y_scale = Scale::kStraight;
  std::optional<AxisRange> x, y;
  bool one_scale = false;  // a metre is as long along y as along x; for straight axes
  std::vector<PlotCurve> curves;
  std::string warning{};    // behind the title, may be empty
  double room_below = 0.0;  // left free under the plot [px]
  // At 1, 2, 3 ... of the x axis in place of numbers.
  std::vector<std::string> x_words{};
};

// Colours that differ in print and for most eyes (after Okabe and Ito); they repeat.
inline constexpr size_t kCurveColours = 8;
Colour colour_of_curve(int number);

// Corners of a point's marker. It changes each time the colours begin anew, so that 24 sets of
// points are told apart.
int marker_corners(int number);

// Grid, curves and frame between two corners [px]; neither title nor key.
void draw_frame_of(const CurvePlot& plot, const Vec2& upper_left, const Vec2& lower_right,
                   Canvas& canvas);

// Places the labels of curves in lines between two sides, from `top` on [px]; draws them if there
// is a canvas. Returns the height that they take [px].
double lay_out_key(const std::vector<PlotCurve>& curves, double left, double right, double top,
                   Canvas* canvas);

// 1200 px wide. What lies outside a given range is left out. A logarithmic axis needs values > 0.
Canvas draw_curves(const CurvePlot& plot);

}  // namespace muckpile
