// SPDX-License-Identifier: GPL-2.0-or-later
// Picture of a blast plan: holes, firing times, contours of equal time, burden relief.
// Scope: see blast_plan.h.
#include <algorithm>
#include <cmath>

#include "draw/axes.h"
#include "measure/contours.h"
#include "report/blast_plan.h"
#include "report/block_colours.h"

namespace muckpile {
namespace {

using Plan = std::vector<PlannedHole>;

constexpr double kLeft = 105.0, kRight = 30.0, kAbove = 150.0, kBelow = 85.0;  // margins [px]
constexpr double kMostSide = 1400.0;  // of the plot area [px]
constexpr double kTextSize = 18.0, kSmallText = 15.0;

std::vector<Vec2> collars(const Plan& plan) {
  std::vector<Vec2> places;
  for (const PlannedHole& hole : plan) places.push_back(hole.collar);
  return places;
}

std::vector<double> milliseconds(const Plan& plan) {
  std::vector<double> times;
  for (const PlannedHole& hole : plan) times.push_back(1e3 * hole.fires);
  return times;
}

// The holes with a margin of the mean distance between neighbours.
std::pair<AxisRange, AxisRange> frame(const Plan& plan, const std::vector<HolePolygon>& outlines) {
  std::vector<Vec2> places = collars(plan);
  const auto range = [&](Eigen::Index k) {
    const auto [low, high] =
        std::ranges::minmax_element(places, {}, [k](const Vec2& p) { return p[k]; });
    return AxisRange{(*low)[k], (*high)[k]};
  };
  AxisRange x = range(0), y = range(1);
  const double longer = std::max(x.high - x.low, y.high - y.low);
  const double area = std::max({1.0, (x.high - x.low) * (y.high - y.low), 0.1 * longer * longer});
  const double margin = std::sqrt(area / static_cast<double>(places.size()));
  for (const HolePolygon& outline : outlines)
    places.insert(places.end(), outline.corners.begin(), outline.corners.end());
  const AxisRange all_x = range(0), all_y = range(1);
  constexpr double kRoom = 0.2;  // of the margin, around outlines
  return {{std::min(x.low - margin, all_x.low - kRoom * margin),
           std::max(x.high + margin, all_x.high + kRoom * margin)},
          {std::min(y.low - margin, all_y.low - kRoom * margin),
           std::max(y.high + margin, all_y.high + kRoom * margin)}};
}

void draw_contours(const Plan& plan, const Axes& axes, const ColourMap& map, Canvas& canvas) {
  constexpr int kWanted = 15;
  const std::vector<Vec2> places = collars(plan);
  const std::vector<Triangle> triangles = triangulate(places);
  for (const double level : straight_ticks({map.low(), map.high()}, kWanted)) {
    for (const auto& [from, to] : contour(places, milliseconds(plan), triangles, level)) {
      canvas.line(axes.place(from.x(), from.y()), axes.place(to.x(), to.y()), 2.5, map.at(level));
    }
  }
}

void draw_arrow(const Vec2& from, const Vec2& to, double thickness, Colour colour, Canvas& canvas) {
  constexpr double kHead = 11.0;  // [px]
  const Vec2 along = (to - from).normalized(), across(-along.y(), along.x());
  canvas.line(from, to - 0.8 * kHead * along, thickness, colour);
  const std::vector<Vec2> head{to, to - kHead * along + 0.45 * kHead * across,
                               to - kHead * along - 0.45 * kHead * across};
  canvas.fill(head, colour);
}

// From each hole to the one that it fires towards.
void draw_relief(const Plan& plan, const Axes& axes, Canvas& canvas) {
  constexpr double kClear = 10.0;  // of the holes [px]
  for (const PlannedHole& hole : plan) {
    if (!hole.relief.in_front) continue;
    const Vec2& other = plan[*hole.relief.in_front].collar;
    const Vec2 from = axes.place(hole.collar.x(), hole.collar.y());
    const Vec2 to = axes.place(other.x(), other.y());
    const Vec2 along = (to - from).normalized();
    draw_arrow(from + kClear * along, to - kClear * along, 1.5, kInk, canvas);
    canvas.text(0.5 * (from + to) + Vec2(6.0, -6.0), spelled(1e3 * *hole.relief.per_metre, 2),
                kSmallText, kInk);
  }
}

void draw_holes(const Plan& plan, const Axes& axes, const ColourMap& map, Canvas& canvas) {
  constexpr double kRadius = 7.0;
  constexpr int kCorners = 16;
  for (const PlannedHole& hole : plan) {
    const Vec2 at = axes.place(hole.collar.x(), hole.collar.y());
    std::vector<Vec2> disc;
    for (int k = 0; k < kCorners; ++k) {
      const double angle = 2.0 * M_PI * k / kCorners;
      disc.push_back(at + kRadius * Vec2(std::cos(angle), std::sin(angle)));
    }
    canvas.fill(disc, map.at(1e3 * hole.fires));
    disc.push_back(disc.front());
    canvas.polyline(disc, 1.5, kInk);
    canvas.text(at + Vec2(0.0, -11.0), spelled(1e3 * hole.fires, 4), kTextSize, kInk,
                Anchor::kCentre);
    std::string below = hole.name;
    if (!std::isnan(hole.mass)) below += ", " + spelled(hole.mass, 3) + " kg";
    canvas.text(at + Vec2(0.0, 24.0), below, kSmallText, kInk, Anchor::kCentre);
  }
}

// The rock of each hole.
void draw_outlines(const std::vector<HolePolygon>& outlines, const Axes& axes, Canvas& canvas) {
  for (const HolePolygon& outline : outlines) {
    if (outline.corners.empty()) continue;
    std::vector<Vec2> ring = axes.places(outline.corners);
    ring.push_back(ring.front());
    canvas.polyline(ring, 2.0, kGrey);
  }
}

}  // namespace

Canvas draw_plan(const HoleTable& table, const Plan& plan,
                 const std::vector<HolePolygon>& outlines) {
  const auto [x, y] = frame(plan, outlines);
  const double scale = kMostSide / std::max(x.high - x.low, y.high - y.low);
  const double width = std::max(600.0, scale * (x.high - x.low));
  const double height = scale * (y.high - y.low);
  const double more = 0.5 * (width / scale - (x.high - x.low));
  Canvas canvas(static_cast<int>(kLeft + width + kRight),
                static_cast<int>(kAbove + height + kBelow), kWhite);
  const Axes axes({kLeft, kAbove}, {kLeft + width, kAbove + height}, {x.low - more, x.high + more},
                  y);
  const std::vector<double> times = milliseconds(plan);
  const auto [first, last] = std::ranges::minmax(times);
  BlockColours colours;
  colours.map = amount_map(first, std::max(last, first + 1e-3));
  colours.label = "first deck fires [ms]";
  axes.draw_grid(canvas);
  draw_outlines(outlines, axes, canvas);
  draw_contours(plan, axes, *colours.map, canvas);
  draw_relief(plan, axes, canvas);
  draw_holes(plan, axes, *colours.map, canvas);
  axes.draw_frame(canvas, "x [m]", "y [m]");
  canvas.text({kLeft, 40.0}, "Plan of the blast", 30.0, kInk);
  canvas.text(
      {kLeft, 74.0},
      std::to_string(table.holes()) + " holes, " + std::to_string(table.decks().size()) + " decks",
      kTextSize + 4.0, kInk);
  canvas.text({kLeft, 100.0},
              outlines.empty() ? "arrows: fires towards, ms/m"
                               : "arrows: fires towards, ms/m; grey: rock of each hole",
              kSmallText + 2.0, kInk);
  canvas.text({kLeft, 132.0}, "throw", kTextSize, kInk);
  draw_arrow({kLeft + 58.0, 126.0}, {kLeft + 140.0, 126.0}, 3.0, kInk, canvas);
  draw_legend(colours, {kLeft + width - 310.0, 22.0}, canvas);
  return canvas;
}

}  // namespace muckpile
