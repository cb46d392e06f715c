// SPDX-License-Identifier: GPL-2.0-or-later
// Sub-command heights: a map of the pile and of what stands, backbreak, toe left, volumes.
// Scope: benches that profile measures.
#include <algorithm>
#include <cmath>

#include "draw/axes.h"
#include "draw/png_file.h"
#include "draw/title.h"
#include "io/csv_writer.h"
#include "io/mine_frame.h"
#include "measure/height_map.h"
#include "measure/places.h"
#include "measure/start_extent.h"
#include "report/bench_scene.h"
#include "report/block_colours.h"
#include "report/hole_outlines.h"
#include "report/not_measurable.h"
#include "report/notes.h"
#include "report/reports.h"
#include "report/run_data.h"

namespace muckpile {
namespace {

constexpr double kShift = 0.1;  // rock behind the last row that moved farther is loose [m]

struct Heights {
  HeightMap map;
  Reach shifted, broken;
  ToeLeft toe;
  double prism = 0.0;                // in front of the last row, abreast of the holes [m3]
  double moved = 0.0;                // all that was broken out [m3]
  double before = 0.0, after = 0.0;  // under the surfaces, above the floor [m3]
  double cut = 0.0, fill = 0.0;      // between them, where the one after is lower, and higher [m3]
};

void add_volumes(Heights& heights) {
  const HeightMap& map = heights.map;
  const double cell = map.grid.dx * map.grid.dy;
  for (size_t k = 0; k < map.grid.cells(); ++k) {
    const double rise = map.after[k] - map.before[k];
    heights.before += (map.before[k] - map.floor[k]) * cell;
    heights.after += (map.after[k] - map.floor[k]) * cell;
    (rise > 0.0 ? heights.fill : heights.cut) += std::abs(rise) * cell;
  }
}

Heights heights_of(const RunData& run, const BenchScene& bench) {
  const BenchPlanes planes = bounded_by_rock(bench.planes, run.blocks);
  Heights heights;
  heights.map = height_map(run.blocks, run.last, run.moved, run.lies, run.cell, run.floor);
  heights.shifted = backbreak(run.blocks, shifted(run.blocks, run.last, kShift), planes,
                              bench.depth, run.block_size);
  heights.broken = backbreak(run.blocks, loosened(run.last), planes, bench.depth, run.block_size);
  heights.toe = toe_left(run.blocks, run.last, run.moved, planes, bench.depth);
  for (size_t b = 0; b < run.blocks.size(); ++b) {
    if (planes.in_front_of(bench.depth, run.blocks[b].centroid))
      heights.prism += run.blocks[b].volume;
    if (run.moved[b] != 0) heights.moved += run.blocks[b].volume;
  }
  add_volumes(heights);
  return heights;
}

void write_table(const HeightMap& map, const ResultFolder& folder) {
  const std::optional<MineFrame> frame = mine_frame(folder);
  CsvWriter csv(folder.file("heights.csv"),
                with_mine_columns("x_m,y_m,before_m,after_m,rock_in_place_m", frame));
  for (int j = 0; j < map.grid.ny; ++j) {
    for (int i = 0; i < map.grid.nx; ++i) {
      const size_t k = map.grid.at(i, j);
      const double x = map.grid.x(i), y = map.grid.y(j);
      csv.row_at({x, y, map.before[k], map.after[k], map.in_place[k]}, mine_place(frame, x, y));
    }
  }
}

struct Frame {
  AxisRange x, y;  // [m]
};

// All rock but the few blocks that flew farthest.
Frame frame_of(const RunData& run, const HeightMap& map) {
  constexpr double kRoom = 2.0;  // [m]
  const Extent before = extent_at_start(run.blocks);
  const ColumnGrid& g = map.grid;
  const auto inside = [](double low, double value, double high) {
    return std::clamp(value, low, high);
  };
  const double x_end = g.x0 + g.nx * g.dx, y_end = g.y0 + g.ny * g.dy;
  return {
      {g.x0, inside(before.high.x(), place_of_share(run.last, 0, 0.995) + kRoom, x_end)},
      {inside(g.y0, std::min(before.low.y(), place_of_share(run.last, 1, 0.002)) - kRoom, y_end),
       inside(g.y0, std::max(before.high.y(), place_of_share(run.last, 1, 0.998)) + kRoom, y_end)}};
}

void draw_cells(const HeightMap& map, const Frame& frame, const ColourMap& colours,
                const Axes& axes, Canvas& canvas) {
  const ColumnGrid& g = map.grid;
  for (int j = 0; j < g.ny; ++j) {
    for (int i = 0; i < g.nx; ++i) {
      const double x = g.x(i), y = g.y(j), height = map.after[g.at(i, j)];
      if (height <= map.floor[g.at(i, j)] || x < frame.x.low || x > frame.x.high ||
          y < frame.y.low || y > frame.y.high)
        continue;
      const bool stayed = map.in_place[g.at(i, j)] >= height;
      const Colour colour = colours.at(height);
      const auto corner = [&](double side) {
        return axes.place(std::clamp(x + side * g.dx, frame.x.low, frame.x.high),
                          std::clamp(y + side * g.dy, frame.y.low, frame.y.high));
      };
      canvas.rectangle(corner(-0.5), corner(0.5), stayed ? mix(colour, kGrey, 0.75) : colour);
    }
  }
}

void draw_bench(const BenchScene& bench, const std::vector<HolePolygon>& outlines,
                const Frame& frame, const Axes& axes, Canvas& canvas) {
  for (const double height : {0.0, bench.height}) {
    const std::vector<Vec2> line =
        axes.places(face_at_height(bench, height, frame.y.low, frame.y.high));
    canvas.dashes(line, 2.0, 9.0, kBench);
  }
  for (const HolePolygon& outline : outlines) {
    if (outline.corners.empty()) continue;
    std::vector<Vec2> ring = axes.places(outline.corners);
    ring.push_back(ring.front());
    canvas.polyline(ring, 1.5, kInk);
  }
  constexpr double kHalf = 4.0;  // of a mark [px]
  for (const Charge& charge : bench.charges) {
    const Vec3 along = charge.collar - charge.toe;
    const Vec2 mouth = foot_of(charge) + bench.height / along.z() * along.head<2>();
    const Vec2 at = axes.place(mouth.x(), mouth.y()), half(kHalf, kHalf);
    canvas.rectangle(at - half, at + half, kSignal);
  }
}

Canvas draw(const Heights& heights, const RunData& run, const BenchScene& bench,
            const std::vector<HolePolygon>& outlines) {
  constexpr double kLeft = 105.0, kRight = 30.0, kAbove = 150.0, kBelow = 85.0, kWidth = 1400.0;
  const Frame frame = frame_of(run, heights.map);
  const double height = kWidth * (frame.y.high - frame.y.low) / (frame.x.high - frame.x.low);
  Canvas canvas(static_cast<int>(kLeft + kWidth + kRight),
                static_cast<int>(kAbove + height + kBelow), kWhite);
  const Axes axes({kLeft, kAbove}, {kLeft + kWidth, kAbove + height}, frame.x, frame.y);
  BlockColours colours;
  double lowest = 0.0;  // of the cells that are drawn
  for (size_t i = 0; i < heights.map.after.size(); ++i)
    if (heights.map.after[i] > heights.map.floor[i])
      lowest = std::min(lowest, heights.map.after[i]);
  const double highest = std::ranges::max(heights.map.after);
  colours.map = amount_map(lowest, highest);
  colours.label = "height after the blast [m]";
  axes.draw_grid(canvas);
  draw_cells(heights.map, frame, *colours.map, axes, canvas);
  draw_bench(bench, outlines, frame, axes, canvas);
  axes.draw_frame(canvas, "x, from the toe of the free face along the throw [m]", "y [m]");
  draw_title({kLeft, 48.0}, "Pile and bench from above", motion_warning(run.still), 30.0, canvas);
  canvas.text({kLeft, 88.0},
              std::string("greyed: rock that stayed; red: collars") +
                  (bench.several_sides ? "" : "; dashed: toe and crest before") +
                  (outlines.empty() ? "" : "; lines: rock of each hole"),
              20.0, kInk);
  canvas.text({kLeft, 118.0},
              "backbreak " + spelled(heights.shifted.largest) + " m · toe left " +
                  spelled(heights.toe.volume) + " m³",
              20.0, kInk);
  draw_legend(colours, {kLeft + kWidth - 310.0, 22.0}, canvas);
  return canvas;
}

nlohmann::ordered_json keys_of(const Heights& heights, bool still) {
  const double none = std::nan(""), solid = heights.map.solid_volume;
  nlohmann::ordered_json keys;
  keys["prism_volume_m3"] = heights.prism;
  keys["moved_volume_m3"] = heights.moved;
  keys["pile_survey_volume_m3"] = still ? heights.map.pile_volume : none;
  keys["pile_survey_swell"] = still && solid > 0.0 ? heights.map.pile_volume / solid : none;
  keys["volume_before_m3"] = heights.before;
  keys["volume_after_m3"] = still ? heights.after : none;
  keys["cut_volume_m3"] = still ? heights.cut : none;
  keys["fill_volume_m3"] = still ? heights.fill : none;
  keys["backbreak_m"] = heights.shifted.largest;
  keys["backbreak_mean_m"] = heights.shifted.mean;
  keys["backbreak_broken_m"] = heights.broken.largest;
  keys["backbreak_broken_mean_m"] = heights.broken.mean;
  keys["toe_left_volume_m3"] = heights.toe.volume;
  keys["toe_left_height_m"] = heights.toe.height;
  return keys;
}

}  // namespace

void report_heights(const ResultFolder& folder, const MeasureOptions& measure) {
  if (folder.scene_word("case") != "bench")
    refuse("heights", "the run must be a bench, got '" + folder.scene_word("case") + "'");
  const RunData run(folder, measure);
  const BenchScene bench = bench_or_take_back(folder, run.blocks, "heights", keys_of({}, false));
  const Heights heights = heights_of(run, bench);
  write_table(heights.map, folder);
  write_png(draw(heights, run, bench, hole_outlines(folder, bench, run.blocks)),
            folder.file("heights.png"));
  nlohmann::ordered_json keys = common_keys(folder);
  keys.update(keys_of(heights, run.still));
  folder.merge_into_summary(keys, {refusal_key("heights")});
}

}  // namespace muckpile
