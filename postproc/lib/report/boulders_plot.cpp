// SPDX-License-Identifier: GPL-2.0-or-later
// Picture of the boulders of a pile, seen from above.
// Scope: see the header.
#include "report/boulders_plot.h"

#include <algorithm>
#include <cmath>

#include "draw/axes.h"
#include "draw/clip.h"
#include "draw/title.h"
#include "io/posed_block.h"
#include "measure/height_map.h"
#include "measure/places.h"
#include "measure/start_extent.h"
#include "report/block_colours.h"
#include "report/notes.h"

namespace muckpile {
namespace {

constexpr double kLeft = 105.0, kRight = 30.0, kAbove = 130.0, kBelow = 85.0;  // margins [px]
constexpr double kWidth = 1400.0, kMostHeight = 1100.0;                        // of the frame [px]
constexpr size_t kNamed = 20;  // of the largest boulders the size is written

struct Frame {
  AxisRange x, y;  // [m]
};

// All boulders, and all rock but the few blocks that flew farthest.
Frame frame_of(const RunData& run, const std::vector<Boulder>& boulders) {
  constexpr double kRoom = 2.0;  // [m]
  const Extent before = extent_at_start(run.blocks);
  AxisRange range[2] = {};
  for (Eigen::Index axis = 0; axis < 2; ++axis) {
    double low = std::min(before.low[axis], place_of_share(run.last, axis, 0.002));
    double high = std::max(before.high[axis], place_of_share(run.last, axis, 0.998));
    for (const Boulder& boulder : boulders) {
      low = std::min(low, boulder.centre[axis]);
      high = std::max(high, boulder.centre[axis]);
    }
    range[axis] = {low - kRoom, high + kRoom};
  }
  return {range[0], range[1]};
}

// The surface after, the higher the darker.
void draw_surface(const RunData& run, const Frame& frame, const Axes& axes, Canvas& canvas) {
  const ColumnGrid grid =
      column_grid(frame.x.low, frame.x.high, frame.y.low, frame.y.high, run.cell);
  const Columns columns = tops_through(grid, run.blocks, run.last.states, run.lies);
  double low = 1e300, high = -1e300;
  for (const double top : columns.top) {
    if (top == kNoRock) continue;
    low = std::min(low, top);
    high = std::max(high, top);
  }
  const ColourMap greys(low, high, {{0.95F, 0.95F, 0.95F}, {0.62F, 0.63F, 0.64F}});
  for (int j = 0; j < grid.ny; ++j) {
    for (int i = 0; i < grid.nx; ++i) {
      const double top = columns.top[grid.at(i, j)];
      if (top == kNoRock) continue;
      const auto corner = [&](double side) {
        return axes.place(std::clamp(grid.x(i) + side * grid.dx, frame.x.low, frame.x.high),
                          std::clamp(grid.y(j) + side * grid.dy, frame.y.low, frame.y.high));
      };
      canvas.rectangle(corner(-0.5), corner(0.5), greys.at(top));
    }
  }
}

// Where the faces of a polyhedron that look up lie in plan, it lies.
void draw_block(const StartBlock& block, const BlockState& state, const Frame& frame, Colour colour,
                const Axes& axes, Canvas& canvas) {
  const std::vector<Vec3> vertices = moved_vertices(block, state);
  for (const std::span<const int> face : block.shape.faces) {
    std::vector<Vec2> outline;
    double area = 0.0;
    for (const int v : face) outline.emplace_back(vertices[static_cast<size_t>(v)].head<2>());
    for (size_t k = 0; k < outline.size(); ++k) {
      const Vec2 &a = outline[k], &b = outline[(k + 1) % outline.size()];
      area += a.x() * b.y() - a.y() * b.x();
    }
    if (area <= 0.0) continue;
    const std::vector<Vec2> seen = clipped(outline, frame.x, frame.y);
    if (seen.empty()) continue;
    std::vector<Vec2> places = axes.places(seen);
    canvas.fill(places, colour);
    places.push_back(places.front());
    canvas.polyline(places, 0.8, scaled(colour, 0.55));
  }
}

void draw_sizes(const std::vector<Boulder>& boulders, const Axes& axes, Canvas& canvas) {
  constexpr double kText = 17.0;
  const size_t from = boulders.size() - std::min(boulders.size(), kNamed);
  for (size_t k = from; k < boulders.size(); ++k) {
    const Vec3& at = boulders[k].centre;
    canvas.text(axes.place(at.x(), at.y()) + Vec2(0.0, 0.35 * kText), spelled(boulders[k].sieve),
                kText, kInk, Anchor::kCentre);
  }
}

std::string title_of(size_t count, double least, double mass_share) {
  return std::to_string(count) + (count == 1 ? " boulder" : " boulders") + " above " +
         spelled(least) + " m by sieve, " + spelled(100.0 * mass_share, 2) +
         " % of the pile's mass";
}

}  // namespace

Canvas draw_boulders(const RunData& run, std::vector<Boulder> boulders, double least,
                     double mass_share) {
  const Frame frame = frame_of(run, boulders);
  double width = kWidth;
  double height = kWidth * (frame.y.high - frame.y.low) / (frame.x.high - frame.x.low);
  if (height > kMostHeight) width *= kMostHeight / height, height = kMostHeight;
  Canvas canvas(static_cast<int>(kLeft + kWidth + kRight),
                static_cast<int>(kAbove + height + kBelow), kWhite);
  const Axes axes({kLeft, kAbove}, {kLeft + width, kAbove + height}, frame.x, frame.y);
  axes.draw_grid(canvas);
  draw_surface(run, frame, axes, canvas);
  std::ranges::sort(boulders, {}, &Boulder::sieve);  // the largest are drawn last
  BlockColours colours;
  const double largest = boulders.empty() ? least : boulders.back().sieve;
  colours.map = ColourMap(least, std::max(largest, 1.001 * least),
                          {{0.99F, 0.87F, 0.55F}, {0.96F, 0.55F, 0.24F}, {0.80F, 0.13F, 0.13F}});
  colours.label = "size by sieve [m]";
  for (const Boulder& boulder : boulders)
    for (const size_t b : boulder.blocks)
      draw_block(run.blocks[b], run.last.states[b], frame, colours.map->at(boulder.sieve), axes,
                 canvas);
  draw_sizes(boulders, axes, canvas);
  axes.draw_frame(canvas, "x [m]", "y [m]");
  draw_title({kLeft, 48.0}, title_of(boulders.size(), least, mass_share), motion_warning(run.still),
             30.0, canvas);
  canvas.text({kLeft, 88.0},
              "seen from above, those under other rock as well; grey: the surface, darker where it "
              "is higher",
              20.0, kInk);
  if (!boulders.empty()) draw_legend(colours, {kLeft + kWidth - 310.0, 22.0}, canvas);
  return canvas;
}

}  // namespace muckpile
