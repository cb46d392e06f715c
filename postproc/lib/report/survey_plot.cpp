// SPDX-License-Identifier: GPL-2.0-or-later
// Picture of a run's surface against a surveyed one.
// Scope: see the header.
#include "report/survey_plot.h"

#include <algorithm>
#include <cmath>

#include "draw/axes.h"
#include "draw/curve_plot.h"
#include "report/block_colours.h"

namespace muckpile {
namespace {

constexpr double kLeft = 105.0, kRight = 40.0, kAbove = 145.0, kBetween = 95.0;  // [px]
constexpr double kMapWidth = 1250.0, kMapHeight = 800.0, kProfileHeight = 330.0, kBelow = 80.0;
constexpr double kTextSize = 20.0;
constexpr Colour kNotCompared{0.80F, 0.80F, 0.80F};

struct Frame {
  AxisRange x, y;  // [m]
};

// The compared cells and a little room.
Frame frame_of(const SurfacePair& pair) {
  constexpr double kRoom = 0.03;  // of the frame's length
  const ColumnGrid& g = pair.grid;
  Frame frame{{1e300, -1e300}, {1e300, -1e300}};
  for (int j = 0; j < g.ny; ++j) {
    for (int i = 0; i < g.nx; ++i) {
      if (pair.compared[g.at(i, j)] == 0) continue;
      frame.x = {std::min(frame.x.low, g.x(i)), std::max(frame.x.high, g.x(i))};
      frame.y = {std::min(frame.y.low, g.y(j)), std::max(frame.y.high, g.y(j))};
    }
  }
  const double room = kRoom * (frame.x.high - frame.x.low) + g.dx;
  return {{frame.x.low - room, frame.x.high + room}, {frame.y.low - room, frame.y.high + room}};
}

// Pixels of a metre: the same along x and y, and the map fits its place.
double scale_of(const Frame& frame) {
  return std::min(kMapWidth / (frame.x.high - frame.x.low),
                  kMapHeight / (frame.y.high - frame.y.low));
}

// Rock of the run without a surveyed height is grey.
void draw_cells(const SurfacePair& pair, const Frame& frame, const ColourMap& colours,
                const Axes& axes, Canvas& canvas) {
  const ColumnGrid& g = pair.grid;
  const Vec2 half(0.5 * g.dx, 0.5 * g.dy);
  for (int j = 0; j < g.ny; ++j) {
    for (int i = 0; i < g.nx; ++i) {
      const size_t k = g.at(i, j);
      const Vec2 at(g.x(i), g.y(j));
      const Vec2 low = at - half, high = at + half;
      if (low.x() < frame.x.low || high.x() > frame.x.high || low.y() < frame.y.low ||
          high.y() > frame.y.high)
        continue;
      const bool unknown = std::isnan(pair.survey[k]) && pair.run[k] > 0.0;
      if (pair.compared[k] == 0 && !unknown) continue;
      canvas.rectangle(axes.place(low.x(), low.y()), axes.place(high.x(), high.y()),
                       unknown ? kNotCompared : colours.at(pair.run[k] - pair.survey[k]));
    }
  }
}

void draw_words(const SurfaceDifference& d, Canvas& canvas) {
  canvas.text({kLeft, 46.0}, "Surface of the run less the survey", 30.0, kInk);
  canvas.text({kLeft, 84.0},
              "run higher: " + spelled(d.above) + " m³, lower: " + spelled(d.below) + " m³, on " +
                  spelled(d.area) + " m²",
              kTextSize, kInk);
  canvas.text({kLeft, 114.0},
              "vertical: mean " + spelled(d.mean) + " m, RMS " + spelled(d.rms) + " m, P90 " +
                  spelled(d.p90) + " m; grey: no surveyed height",
              kTextSize, kInk);
}

CurvePlot profile_plot(const ProfilePair& profiles, const AxisRange& x) {
  CurvePlot plot;
  plot.x = x;
  plot.x_label = "x [m]";
  plot.y_label = "height, mean over y [m]";
  plot.curves = {{"run", CurveStyle::kLine, 1, {}}, {"survey", CurveStyle::kDashed, 7, {}}};
  for (size_t k = 0; k < profiles.x.size(); ++k) {
    plot.curves[0].points.emplace_back(profiles.x[k], profiles.run[k]);
    plot.curves[1].points.emplace_back(profiles.x[k], profiles.survey[k]);
  }
  return plot;
}

}  // namespace

Canvas draw_survey(const SurfacePair& pair, const ProfilePair& profiles,
                   const SurfaceDifference& difference) {
  constexpr double kShown = 0.98;    // of the area within the colours
  constexpr double kLeast = 0.01;    // so that equal surfaces have a scale [m]
  constexpr double kKeyRoom = 45.0;  // [px]
  const Frame frame = frame_of(pair);
  const double scale = scale_of(frame);
  const double width = scale * (frame.x.high - frame.x.low);
  const double map_end = kAbove + scale * (frame.y.high - frame.y.low);
  const double top = map_end + kBetween + kKeyRoom;
  Canvas canvas(
      static_cast<int>(kLeft + kMapWidth + kRight),
      static_cast<int>(profiles.x.empty() ? map_end + kBelow : top + kProfileHeight + kBelow),
      kWhite);
  const Axes axes({kLeft, kAbove}, {kLeft + width, map_end}, frame.x, frame.y);
  BlockColours colours;
  colours.map = difference_map(std::max(kLeast, difference_at_share(pair, kShown)));
  colours.label = "run less survey [m]";
  axes.draw_grid(canvas);
  draw_cells(pair, frame, *colours.map, axes, canvas);
  axes.draw_frame(canvas, "x [m]", "y [m]");
  draw_words(difference, canvas);
  draw_legend(colours, {kLeft + kMapWidth - 310.0, 22.0}, canvas);
  if (profiles.x.empty()) return canvas;
  const CurvePlot plot = profile_plot(profiles, frame.x);
  lay_out_key(plot.curves, kLeft, kLeft + width, map_end + kBetween, &canvas);
  draw_frame_of(plot, {kLeft, top}, {kLeft + width, top + kProfileHeight}, canvas);
  return canvas;
}

}  // namespace muckpile
