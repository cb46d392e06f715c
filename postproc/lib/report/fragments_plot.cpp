// SPDX-License-Identifier: GPL-2.0-or-later
// Picture of a pile's size curves.
// Scope: see the header.
#include "report/fragments_plot.h"

#include <algorithm>
#include <cmath>

#include "draw/axes.h"
#include "draw/curve_plot.h"
#include "draw/text.h"
#include "draw/title.h"

namespace muckpile {
namespace {

constexpr int kWidth = 1200, kHeight = 860;
constexpr double kLeft = 105.0, kRight = 30.0, kTop = 205.0, kBelow = 85.0;  // margins [px]
constexpr double kText = 20.0;

// A passing curve rises at each size by the mass of the pieces of that size.
std::vector<Vec2> steps(const std::vector<SizePoint>& curve, const AxisRange& x) {
  std::vector<Vec2> points{{x.low, 0.0}};
  for (const SizePoint& p : curve) {
    points.emplace_back(p.size, points.back().y());
    points.emplace_back(p.size, 100.0 * p.passing);
  }
  points.emplace_back(x.high, 100.0);
  return points;
}

std::vector<Vec2> line_of(const SizeTarget& target, const AxisRange& x) {
  constexpr int kPoints = 200;
  std::vector<Vec2> points;
  for (int k = 0; k <= kPoints; ++k) {
    const double size = x.low * std::pow(x.high / x.low, static_cast<double>(k) / kPoints);
    points.emplace_back(size, 100.0 * target.passing(size));
  }
  return points;
}

// Half a decade below the smallest block, so that what is finer by fit or formula shows.
AxisRange sizes_of(const FragmentCurves& c) {
  const double low = std::min(c.block_sieve.front().size, c.by_volume.front().size);
  const double high = std::max(c.sieve.back().size, c.by_volume.back().size);
  return {low / std::sqrt(10.0), 1.25 * high};
}

struct KeyLine {
  std::string name;
  Colour colour;
  double thickness;
  bool dashed;
};

struct Drawn {
  std::vector<Vec2> places;  // [px]
  KeyLine line;
};

void draw_key(const std::vector<Drawn>& curves, Canvas& canvas) {
  constexpr double kStroke = 44.0, kFirst = 124.0, kStep = 30.0;
  double x = kLeft, y = kFirst;
  for (const auto& [places, line] : curves) {
    const double width = kStroke + 36.0 + text_mask(line.name, kText, 0.0).advance.x();
    if (x + width > kWidth) {
      x = kLeft;
      y += kStep;
    }
    const Vec2 stroke[] = {{x, y - 7.0}, {x + kStroke, y - 7.0}};
    if (line.dashed) {
      canvas.dashes(stroke, line.thickness, 8.0, line.colour);
    } else {
      canvas.polyline(stroke, line.thickness, line.colour);
    }
    canvas.text({x + kStroke + 8.0, y}, line.name, kText, kInk);
    x += width;
  }
}

// Whether a curve comes into a box around a place [px].
bool meets(const std::vector<Vec2>& curve, const Vec2& middle, const Vec2& half) {
  const Vec2 low = middle - half, high = middle + half;
  for (size_t k = 1; k < curve.size(); ++k) {
    const Vec2 from = curve[k - 1].cwiseMin(curve[k]), to = curve[k - 1].cwiseMax(curve[k]);
    if ((from.array() <= high.array()).all() && (to.array() >= low.array()).all()) return true;
  }
  return false;
}

// Where the middle of a box may stand between two heights so that no curve is in it, as near to
// their middle as may be [px]; at the top where there is no such place.
double free_height(double x, const AxisRange& y, const Vec2& half,
                   const std::vector<Drawn>& curves) {
  constexpr double kStep = 2.0;
  const double middle = 0.5 * (y.low + y.high);
  for (double off = 0.0; middle - off >= y.low; off += kStep) {
    for (const double each : {middle - off, middle + off}) {
      const auto is_here = [&](const Drawn& curve) { return meets(curve.places, {x, each}, half); };
      if (std::ranges::none_of(curves, is_here)) return each;
    }
  }
  return y.low;
}

// Lines of words from below to above, between two sizes where no curve is.
void draw_upright(const std::vector<std::string>& lines, const AxisRange& between, const Axes& axes,
                  const std::vector<Drawn>& curves, Canvas& canvas) {
  constexpr double kLine = 28.0, kRoom = 10.0;  // [px]
  double length = 0.0;
  for (const std::string& line : lines)
    length = std::max(length, text_mask(line, kText, 0.0).advance.x());
  const Vec2 half(0.5 * kLine * static_cast<double>(lines.size()), 0.5 * length + kRoom);
  const Vec2 top = axes.place(between.low, 100.0), bottom = axes.place(between.high, 0.0);
  const double x = 0.5 * (top.x() + bottom.x());
  const double y = free_height(x, {top.y() + half.y(), bottom.y() - half.y()}, half, curves);
  Vec2 at(x - half.x() + 0.75 * kLine, y);  // on the base line of the first one
  for (const std::string& line : lines) {
    canvas.text(at, line, kText, kInk, Anchor::kCentre, 90.0);
    at.x() += kLine;
  }
}

// What no block can show: nothing is finer than the finest block, and only joints that hold make
// pieces coarser than the coarsest.
void draw_limits(const FragmentCurves& c, const Axes& axes, const AxisRange& x,
                 const std::vector<Drawn>& curves, Canvas& canvas) {
  const double finest = c.block_sieve.front().size, coarsest = c.block_sieve.back().size;
  canvas.rectangle(axes.place(x.low, 100.0), axes.place(finest, 0.0), kGrey, 0.22);
  canvas.rectangle(axes.place(coarsest, 100.0), axes.place(x.high, 0.0), kGrey, 0.12);
  draw_upright({"finer than any block:", "not simulated"}, {x.low, finest}, axes, curves, canvas);
  draw_upright({"blocks that hold together"}, {coarsest, x.high}, axes, curves, canvas);
}

std::string percent(double share) { return spelled(100.0 * share, 2) + " %"; }

std::string with_error(double value, double error) {
  return spelled(value) + " ± " + spelled(error, 1);
}

std::vector<Drawn> curves_of(const FragmentCurves& c, const Axes& axes, const AxisRange& x) {
  std::vector<Drawn> curves;
  const auto add = [&](const std::vector<Vec2>& points, const KeyLine& line) {
    curves.push_back({axes.places(points), line});
  };
  add(steps(c.block_sieve, x), {"blocks by sieve, if every joint broke", kGrey, 2.0, false});
  add(steps(c.by_volume, x), {"fragments by volume^(1/3)", colour_of_curve(5), 2.0, false});
  add(steps(c.sieve, x), {"fragments by sieve", kBench, 3.5, false});
  if (c.rosin_rammler)
    add(line_of(c.rosin_rammler->curve(), x),
        {"Rosin-Rammler fit, n " +
             with_error(c.rosin_rammler->shape, c.rosin_rammler->shape_error) + ", RMS " +
             percent(c.rosin_rammler->rms),
         colour_of_curve(1), 2.2, false});
  if (c.swebrec)
    add(line_of(c.swebrec->curve(), x),
        {"Swebrec fit, b " + with_error(c.swebrec->shape, c.swebrec->shape_error) + ", RMS " +
             percent(c.swebrec->rms),
         colour_of_curve(2), 2.2, false});
  if (c.kuz_ram)
    add(line_of(c.kuz_ram->curve(), x),
        {"Kuz-Ram, a formula, x50 " + spelled(c.kuz_ram->x50) + " m, n " + spelled(c.kuz_ram->n),
         kSignal, 2.2, true});
  return curves;
}

void draw_lines(const std::vector<Drawn>& curves, Canvas& canvas) {
  for (const auto& [places, line] : curves) {
    if (line.dashed) {
      canvas.dashes(places, line.thickness, 8.0, line.colour);
    } else {
      canvas.polyline(places, line.thickness, line.colour);
    }
  }
}

}  // namespace

Canvas draw_fragments(const FragmentCurves& curves, const std::string& title,
                      const std::string& warning) {
  Canvas canvas(kWidth, kHeight, kWhite);
  draw_title({kLeft, 48.0}, title, warning, 30.0, canvas);
  if (curves.sieve.empty()) {
    canvas.text({kLeft, 100.0}, "no rock was broken out", 22.0, kInk);
    return canvas;
  }
  const AxisRange x = sizes_of(curves);
  const Axes axes({kLeft, kTop}, {kWidth - kRight, kHeight - kBelow}, x, {0.0, 100.0},
                  Scale::kLogarithmic);
  axes.draw_grid(canvas);
  const std::vector<Drawn> drawn = curves_of(curves, axes, x);
  draw_limits(curves, axes, x, drawn, canvas);
  draw_lines(drawn, canvas);
  draw_key(drawn, canvas);
  axes.draw_frame(canvas, "size [m]", "mass passing [%]");
  std::string numbers = "sieve";
  for (const int share : {20, 50, 80})
    numbers += (share == 20 ? " P" : " · P") + std::to_string(share) + " " +
               spelled(size_at(curves.sieve, 0.01 * share)) + " m";
  canvas.text({kLeft, 86.0}, numbers, 22.0, kBench);
  return canvas;
}

}  // namespace muckpile
