// SPDX-License-Identifier: GPL-2.0-or-later
// Sub-command section: rock and heights along any line in plan.
// Scope: every scene; benches and heaps have a floor.
#include <algorithm>
#include <cmath>

#include "args/input_error.h"
#include "draw/png_file.h"
#include "io/charges.h"
#include "io/csv_writer.h"
#include "io/mine_frame.h"
#include "measure/columns.h"
#include "measure/trough.h"
#include "report/notes.h"
#include "report/plan_line_of.h"
#include "report/reports.h"
#include "report/run_section.h"

namespace muckpile {
namespace {

// Along the line; NaN where there is neither rock nor a floor [m].
struct LineHeights {
  std::vector<double> distance, before, after, in_place;
  std::vector<double> floor;  // NaN where there is none
  double step = 0.0;
};

// Of the cells of a grid along the line; lower than all rock where there is none.
std::vector<double> floor_along(const PlanLine& line, const ColumnGrid& grid, const RunData& run,
                                bool floor) {
  std::vector<double> heights;
  for (int j = 0; j < grid.ny; ++j) {
    for (int i = 0; i < grid.nx; ++i) {
      const Vec2 at = line.at(grid.x(i)) + grid.y(j) * line.left();
      heights.push_back(floor ? run.floor.at(at.x(), at.y()) : kNoRock);
    }
  }
  return heights;
}

// Means over the width of the grid.
std::vector<double> mean_tops(const ColumnGrid& grid, const std::vector<double>& tops,
                              const std::vector<double>& floor) {
  std::vector<double> means;
  for (int i = 0; i < grid.nx; ++i) {
    double sum = 0.0;
    int known = 0;
    for (int j = 0; j < grid.ny; ++j) {
      const double top = std::max(tops[grid.at(i, j)], floor[grid.at(i, j)]);
      if (top == kNoRock) continue;
      sum += top;
      ++known;
    }
    means.push_back(known > 0 ? sum / known : std::nan(""));
  }
  return means;
}

LineHeights heights_along(const PlanLine& line, const RunData& run, double width, bool floor) {
  ColumnGrid grid = column_grid(0.0, line.length(), -0.5 * width, 0.5 * width, run.cell);
  grid.nx = std::max(1, static_cast<int>(std::lround(line.length() / grid.dx)));
  grid.dx = line.length() / grid.nx;  // whole columns from point to point
  std::vector<char> stayed(run.moved);
  for (size_t b = 0; b < stayed.size(); ++b) stayed[b] = run.moved[b] == 0 && run.lies[b] != 0;
  const std::vector<BlockState> after = seen_along(line, run.last.states);
  const std::vector<BlockState> before = seen_along(line, start_snapshot(run.blocks).states);
  const std::vector<char> all(run.blocks.size(), 1);
  LineHeights heights;
  heights.step = grid.dx;
  for (int i = 0; i < grid.nx; ++i) heights.distance.push_back(grid.x(i));
  const std::vector<double> floors = floor_along(line, grid, run, floor);
  const auto means = [&](const std::vector<BlockState>& states, const std::vector<char>& keep) {
    return mean_tops(grid, tops_through(grid, run.blocks, states, keep).top, floors);
  };
  heights.before = means(before, all);
  heights.after = means(after, run.lies);
  heights.in_place = means(after, stayed);
  heights.floor = mean_tops(grid, floors, floors);
  return heights;
}

void require_width(const LineOptions& options) {
  constexpr double kWidest = 1e4;  // [m]
  if (options.width && !(*options.width <= kWidest))
    throw InputError("section: --width must be at most 1e4 m, got '" + spelled(*options.width) +
                     "'");
}

void require_rock(const LineHeights& heights, const PlanLine& line, const RunData& run) {
  const auto is_rock = [&](const std::vector<double>& tops) {
    for (size_t i = 0; i < tops.size(); ++i)
      if (!std::isnan(tops[i]) && tops[i] != heights.floor[i]) return true;
    return false;
  };
  if (is_rock(heights.before) || is_rock(heights.after)) return;
  const Extent rock = extent_of(run.blocks, run.last.states);
  throw InputError("section: the line " + words_of(line) + " meets no rock, which lies from x = " +
                   spelled(rock.low.x()) + " to " + spelled(rock.high.x()) +
                   " m, y = " + spelled(rock.low.y()) + " to " + spelled(rock.high.y()) + " m");
}

void write_table(const LineHeights& heights, const PlanLine& line, const ResultFolder& folder) {
  const std::optional<MineFrame> frame = mine_frame(folder);
  CsvWriter csv(folder.file("section.csv"),
                with_mine_columns("distance_m,x_m,y_m,before_m,after_m,rock_in_place_m", frame));
  for (size_t i = 0; i < heights.distance.size(); ++i) {
    const Vec2 at = line.at(heights.distance[i]);
    csv.row_at({heights.distance[i], at.x(), at.y(), heights.before[i], heights.after[i],
                heights.in_place[i]},
               mine_place(frame, at.x(), at.y()));
  }
}

// Areas between two surfaces [m2]: where `high` is above `low`.
double area_between(const std::vector<double>& high, const std::vector<double>& low, double step) {
  double area = 0.0;
  for (size_t i = 0; i < high.size(); ++i) {
    const double rise = high[i] - low[i];
    if (rise > 0.0) area += rise * step;
  }
  return area;
}

nlohmann::ordered_json keys_of(const LineHeights& heights, const PlanLine& line, const RunData& run,
                               bool bench) {
  nlohmann::ordered_json keys;
  keys["section_from_x_m"] = line.from.x();
  keys["section_from_y_m"] = line.from.y();
  keys["section_to_x_m"] = line.to.x();
  keys["section_to_y_m"] = line.to.y();
  const auto if_still = [&](double value) { return run.still ? value : std::nan(""); };
  keys["section_cut_area_m2"] = if_still(area_between(heights.before, heights.after, heights.step));
  keys["section_fill_area_m2"] =
      if_still(area_between(heights.after, heights.before, heights.step));
  const bool measured = bench && run.still;
  const Trough trough =
      measured ? deepest_trough(heights.distance, heights.after, heights.floor, run.block_size)
               : Trough{};
  keys["section_trough_depth_m"] = measured ? trough.depth : std::nan("");
  keys["section_trough_width_m"] = measured ? trough.width : std::nan("");
  return keys;
}

AxisRange range_of_heights(const LineHeights& heights) {
  double low = 0.0, high = 0.0;
  for (const auto* each : {&heights.before, &heights.after}) {
    for (const double z : *each) low = std::fmin(low, z), high = std::fmax(high, z);
  }
  return {low, high};
}

// Over gaps it goes straight on.
SectionLine with_points(SectionLine line, const LineHeights& heights,
                        const std::vector<double>& z) {
  for (size_t i = 0; i < z.size(); ++i)
    if (!std::isnan(z[i])) line.points.emplace_back(heights.distance[i], z[i]);
  return line;
}

// None where the folder does not tell them.
std::vector<Charge> charges_if_told(const ResultFolder& folder) {
  const bool row = folder.scene_has("burden_m") && folder.scene_has("bench_height_m") &&
                   folder.scene_has("stemming_m") && folder.scene_has("charge_length_m") &&
                   folder.scene_has("hole_diameter_m");
  if (row || std::filesystem::exists(folder.dump("holes.csv"))) return charges_of(folder);
  return charges_of_run(folder);
}

SectionPlot plot_of(const LineHeights& heights, const PlanLine& line, const RunData& run,
                    const LineOptions& options, bool floor) {
  SectionPlot plot{};
  plot.polygons = section_at(0.0, run.blocks, seen_along(line, run.last.states));
  plot.moved = run.moved;
  plot.colours = colours_of_run(run, options.colour_by);
  plot.title = "Section along a line";
  plot.subtitle = words_of(line);
  plot.x_label = "distance along the line [m]";
  plot.note = "t = " + spelled(run.last.time) + " s; rock that stayed is grey";
  plot.warning = motion_warning(run.still);
  const AxisRange z = range_of_heights(heights);
  const double rise = z.high - z.low;
  plot.x = {0.0, line.length()};
  plot.z = {z.low - (floor ? 0.05 : 0.3) * rise, z.high + 0.12 * rise};
  plot.lines = {with_points({{}, kBench, 2.5, true, "surface before"}, heights, heights.before),
                with_points({{}, kSignal, 3.0, false, "surface after"}, heights, heights.after)};
  return plot;
}

}  // namespace

void report_section(const ResultFolder& folder, const MeasureOptions& measure,
                    const LineOptions& options) {
  const PlanLine line = plan_line_of(folder, options, "section");
  require_width(options);
  const std::string scene = folder.scene_word("case");
  const bool floor = scene == "bench" || scene == "heap";
  const RunData run(folder, measure);
  const LineHeights heights = heights_along(line, run, options.width.value_or(run.cell), floor);
  require_rock(heights, line, run);
  SectionPlot plot = plot_of(heights, line, run, options, floor);
  const bool drilled = folder.scene_has("hole_diameter_m");
  plot.bars = charge_bars(line, charges_if_told(folder), 0.5 * options.width.value_or(0.0),
                          drilled ? 0.5 * folder.scene_number("hole_diameter_m") : std::nan(""));
  write_table(heights, line, folder);
  write_png(draw_section(std::move(plot)), folder.file("section.png"));
  nlohmann::ordered_json keys = common_keys(folder);
  keys.update(keys_of(heights, line, run, scene == "bench"));
  folder.merge_into_summary(keys);
}

}  // namespace muckpile
