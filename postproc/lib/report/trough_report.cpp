// SPDX-License-Identifier: GPL-2.0-or-later
// Sub-command trough: the valley between the rock that stands behind a blast and its pile.
// Scope: benches at rest, whatever their face; sections along x, side by side abreast of the holes.
#include <algorithm>
#include <cmath>

#include "draw/curve_plot.h"
#include "draw/png_file.h"
#include "io/charges.h"
#include "io/csv_writer.h"
#include "io/mine_frame.h"
#include "measure/height_map.h"
#include "measure/start_extent.h"
#include "measure/trough.h"
#include "report/bench_scene.h"
#include "report/not_measurable.h"
#include "report/reports.h"
#include "report/run_data.h"

namespace muckpile {
namespace {

// Means over the rows [begin, end) of the grid.
struct Strip {
  double y_low = 0.0, y_high = 0.0;  // [m]
  std::vector<double> before, after, floor;
  Trough trough;
};

struct Troughs {
  std::vector<double> x;  // [m]
  std::vector<Strip> strips;
  Strip mean;  // of all rows
};

AxisRange width_of(const ResultFolder& folder, const RunData& run) {
  const Extent rock = extent_at_start(run.blocks);
  AxisRange width{rock.low.y(), rock.high.y()};
  const std::vector<Charge> charges = charges_of(folder);
  if (charges.empty() || !std::filesystem::exists(folder.dump("holes.csv"))) return width;
  const auto y = [](const Charge& charge) { return foot_of(charge).y(); };
  const auto [low, high] = std::ranges::minmax(charges, {}, y);
  const double beside =
      folder.scene_has("spacing_m") ? 0.5 * folder.scene_number("spacing_m") : 0.0;
  const AxisRange of_holes{std::max(width.low, y(low) - beside),
                           std::min(width.high, y(high) + beside)};
  if (of_holes.low < of_holes.high) return of_holes;
  throw NotMeasurable("trough: the holes must stand in the rock, got holes from y = " +
                      spelled(y(low)) + " to " + spelled(y(high)) + " m beside rock from " +
                      spelled(width.low) + " to " + spelled(width.high) + " m");
}

std::vector<double> row_means(const ColumnGrid& grid, const std::vector<double>& heights, int begin,
                              int end) {
  std::vector<double> means(static_cast<size_t>(grid.nx), 0.0);
  for (int i = 0; i < grid.nx; ++i) {
    for (int j = begin; j < end; ++j)
      means[static_cast<size_t>(i)] += heights[grid.at(i, j)] / (end - begin);
  }
  return means;
}

Strip strip_of(const HeightMap& map, const std::vector<double>& x, int begin, int end,
               double least) {
  Strip strip{
      map.grid.y0 + begin * map.grid.dy,           map.grid.y0 + end * map.grid.dy,
      row_means(map.grid, map.before, begin, end), row_means(map.grid, map.after, begin, end),
      row_means(map.grid, map.floor, begin, end),  {}};
  strip.trough = deepest_trough(x, strip.after, strip.floor, least);
  return strip;
}

Troughs troughs_of(const RunData& run, AxisRange width, double wanted) {
  const HeightMap map = height_map(run.blocks, run.last, run.moved, run.lies, run.cell, run.floor);
  const auto row_at = [&](double y) {
    return std::clamp(static_cast<int>(std::lround((y - map.grid.y0) / map.grid.dy)), 0,
                      map.grid.ny);
  };
  const int low = std::min(row_at(width.low), map.grid.ny - 1),
            high = std::max(row_at(width.high), low + 1);
  const auto count = static_cast<int>(std::lround((width.high - width.low) / wanted));
  const int strips = std::clamp(count, 1, high - low);
  Troughs troughs;
  for (int i = 0; i < map.grid.nx; ++i) troughs.x.push_back(map.grid.x(i));
  for (int k = 0; k < strips; ++k)
    troughs.strips.push_back(strip_of(map, troughs.x, low + k * (high - low) / strips,
                                      low + (k + 1) * (high - low) / strips, run.block_size));
  troughs.mean = strip_of(map, troughs.x, low, high, run.block_size);
  return troughs;
}

double bench_height_of(const Strip& strip) { return *std::ranges::max_element(strip.before); }

double below_bench(const Strip& strip) { return bench_height_of(strip) - strip.trough.z; }

void write_table(const Troughs& troughs, const ResultFolder& folder) {
  const std::optional<MineFrame> frame = mine_frame(folder);
  CsvWriter csv(folder.file("trough.csv"),
                with_mine_columns("y_low_m,y_high_m,x_m,height_m,depth_m,below_bench_m,width_m,"
                                  "area_m2,back_x_m,front_x_m,rim_height_m,pile_height_m",
                                  frame));
  for (const Strip& s : troughs.strips) {
    const Trough& t = s.trough;
    csv.row_at({s.y_low, s.y_high, t.x, t.z, t.depth, below_bench(s), t.width, t.area, t.back,
                t.front, t.rim, t.crest},
               mine_place(frame, t.x, 0.5 * (s.y_low + s.y_high)));
  }
}

nlohmann::ordered_json keys_of(const Troughs& troughs) {
  const auto count = static_cast<double>(troughs.strips.size());
  double depth = 0.0, width = 0.0, volume = 0.0, deepest = 0.0, below = std::nan("");
  int with_trough = 0;
  for (const Strip& strip : troughs.strips) {
    const Trough& trough = strip.trough;
    depth += trough.depth / count;
    width += trough.width / count;
    volume += trough.area * (strip.y_high - strip.y_low);
    deepest = std::max(deepest, trough.depth);
    if (trough.depth > 0.0) ++with_trough, below = std::fmax(below, below_bench(strip));
  }
  nlohmann::ordered_json keys;
  keys["trough_depth_m"] = depth;
  keys["trough_depth_largest_m"] = deepest;
  keys["trough_below_bench_largest_m"] = below;
  keys["trough_width_m"] = width;
  keys["trough_volume_m3"] = volume;
  keys["trough_sections"] = troughs.strips.size();
  keys["trough_sections_with"] = with_trough;
  return keys;
}

std::vector<Vec2> points_over(const std::vector<double>& x, const std::vector<double>& z) {
  std::vector<Vec2> points;
  for (size_t i = 0; i < x.size(); ++i) points.emplace_back(x[i], z[i]);
  return points;
}

// Around the mean surface's valley, along its bottom and back along its rim.
PlotCurve filled_valley(const Troughs& troughs) {
  const Trough& t = troughs.mean.trough;
  PlotCurve band{"", CurveStyle::kBand, 4, {{t.back, t.rim}}};
  for (size_t i = 0; i < troughs.x.size(); ++i) {
    if (troughs.x[i] > t.back && troughs.x[i] < t.front)
      band.points.emplace_back(troughs.x[i], troughs.mean.after[i]);
  }
  band.points.emplace_back(t.front, t.rim);
  return band;
}

CurvePlot plot_of(const Troughs& troughs) {
  CurvePlot plot;
  plot.title = "Power trough: surfaces of sections along the throw";
  plot.x_label = "x, from the toe of the free face along the throw [m]";
  plot.y_label = "height above the floor [m]";
  if (troughs.mean.trough.depth > 0.0) plot.curves.push_back(filled_valley(troughs));
  for (size_t k = 0; k < troughs.strips.size(); ++k)
    plot.curves.push_back({k == 0 ? "after, each section" : "", CurveStyle::kThin, 1,
                           points_over(troughs.x, troughs.strips[k].after)});
  plot.curves.push_back(
      {"before, mean", CurveStyle::kDashed, 0, points_over(troughs.x, troughs.mean.before)});
  plot.curves.push_back(
      {"after, mean", CurveStyle::kLine, 3, points_over(troughs.x, troughs.mean.after)});
  PlotCurve lowest{"lowest point of each section's trough", CurveStyle::kPoints, 5, {}};
  for (const Strip& strip : troughs.strips)
    if (strip.trough.depth > 0.0) lowest.points.emplace_back(strip.trough.x, strip.trough.z);
  if (!lowest.points.empty()) plot.curves.push_back(std::move(lowest));
  // To where the pile ends on average.
  double end = troughs.x.back();
  const double thin = 0.02 * bench_height_of(troughs.mean);
  const Strip& mean = troughs.mean;
  double lowest_floor = 0.0;
  for (size_t i = troughs.x.size(); i-- > 0 && mean.after[i] - mean.floor[i] < thin;)
    end = troughs.x[i];
  for (size_t i = 0; i < troughs.x.size() && troughs.x[i] <= end; ++i)
    lowest_floor = std::min(lowest_floor, mean.after[i]);
  plot.x = AxisRange{troughs.x.front(), end + 1.0};
  plot.y = AxisRange{lowest_floor, 1.12 * std::max(bench_height_of(troughs.mean),
                                                   *std::ranges::max_element(troughs.mean.after))};
  return plot;
}

}  // namespace

void report_trough(const ResultFolder& folder, const MeasureOptions& measure,
                   const TroughOptions& options) {
  if (folder.scene_word("case") != "bench")
    refuse("trough", "the run must be a bench, got '" + folder.scene_word("case") + "'");
  if (!folder.is_still()) {
    const NotMeasurable refusal("trough: the run has not come to rest; its pile has no shape yet");
    take_back(folder, "trough", keys_of({}), refusal);
    throw refusal;
  }
  const RunData run(folder, measure);
  const double usual =
      folder.scene_has("spacing_m") ? folder.scene_number("spacing_m") : 2.0 * run.block_size;
  const Troughs troughs = troughs_of(run, width_of(folder, run), options.strip.value_or(usual));
  write_table(troughs, folder);
  write_png(draw_curves(plot_of(troughs)), folder.file("trough.png"));
  nlohmann::ordered_json keys = common_keys(folder);
  keys.update(keys_of(troughs));
  folder.merge_into_summary(keys, {refusal_key("trough")});
}

}  // namespace muckpile
