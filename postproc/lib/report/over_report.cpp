// SPDX-License-Identifier: GPL-2.0-or-later
// Sub-command over: rock that went over a line which the user draws in plan.
// Scope: every scene; blocks count by their centroids, surfaces by columns.
#include <algorithm>
#include <cmath>

#include "args/input_error.h"
#include "draw/axes.h"
#include "draw/curve_plot.h"
#include "draw/png_file.h"
#include "io/csv_writer.h"
#include "io/mine_frame.h"
#include "measure/height_map.h"
#include "report/notes.h"
#include "report/plan_line_of.h"
#include "report/reports.h"
#include "report/run_data.h"

namespace muckpile {
namespace {

constexpr int kSteps = 20;  // of distance, in table and picture

struct Beyond {
  double distance, volume, mass;  // of all that lies at least so far beyond [m], [m3], [kg]
  Vec3 centre;                    // of that mass; NaN without any [m]
};

std::vector<Beyond> table_of(const OverLine& over) {
  std::vector<Beyond> rows;
  const double farthest = over.pieces.empty() ? 0.0 : over.pieces.front().distance;
  for (int k = 0; k <= kSteps; ++k) {
    Beyond row{k == kSteps ? farthest : farthest * k / kSteps, 0.0, 0.0, Vec3::Zero()};
    for (const OverLine::Piece& piece : over.pieces) {
      if (piece.distance < row.distance) break;
      row.volume += piece.volume;
      row.mass += piece.mass;
      row.centre += piece.mass * piece.place;
    }
    row.centre /= row.mass;
    rows.push_back(row);
    if (farthest == 0.0) break;
  }
  return rows;
}

void write_table(const std::vector<Beyond>& rows, const ResultFolder& folder) {
  const std::optional<MineFrame> frame = mine_frame(folder);
  CsvWriter csv(folder.file("over.csv"),
                with_mine_points("beyond_m,volume_m3,mass_kg,x_m,y_m,z_m", frame, {""}));
  for (const Beyond& row : rows) {
    const Vec3& at = row.centre;
    csv.row_at({row.distance, row.volume, row.mass, at.x(), at.y(), at.z()},
               mine_points(frame, {at}));
  }
}

// Between the surfaces after and before, beyond the line, where the first is higher [m3].
double bulk_beyond(const PlanLine& line, const OverLine& over, const RunData& run) {
  const HeightMap map = height_map(run.blocks, run.last, run.moved, run.lies, run.cell, run.floor);
  double volume = 0.0;
  for (int j = 0; j < map.grid.ny; ++j) {
    for (int i = 0; i < map.grid.nx; ++i) {
      const size_t k = map.grid.at(i, j);
      if (over.sign * line.along_and_left({map.grid.x(i), map.grid.y(j)}).y() <= 0.0) continue;
      volume += std::max(0.0, map.after[k] - map.before[k]) * map.grid.dx * map.grid.dy;
    }
  }
  return volume;
}

// That nothing went over a line of another place is no measure.
void require_near(const PlanLine& line, const RunData& run) {
  constexpr double kFarthest = 1e4;  // [m]; no rock flies as far
  const Extent rock = extent_of(run.blocks, run.last.states);
  const Vec2 middle = 0.5 * (rock.low + rock.high).head<2>();
  const Vec2 along = line.to - line.from, to = middle - line.from;
  const double at = std::clamp(to.dot(along) / along.squaredNorm(), 0.0, 1.0);
  const double away = (to - at * along).norm();
  if (away <= kFarthest) return;
  throw InputError("over: the line " + words_of(line) + " must lie within 10 km of the rock, got " +
                   spelled(1e-3 * away, 4) + " km; places in the mine are given with --mine");
}

CurvePlot plot_of(const std::vector<Beyond>& rows, const PlanLine& line, const RunData& run) {
  CurvePlot plot;
  plot.title = "Rock that went over the line " + words_of(line);
  plot.x_label = "distance beyond the line, at right angles to it [m]";
  plot.y_label = "solid volume at least so far beyond [m³]";
  plot.warning = motion_warning(run.still);
  PlotCurve curve{"", CurveStyle::kLine, 0, {}};
  double most = 1.0, farthest = 1.0;
  for (const Beyond& row : rows) {
    curve.points.emplace_back(row.distance, row.volume);
    most = std::max(most, row.volume);
    farthest = std::max(farthest, row.distance);
  }
  plot.curves.push_back(std::move(curve));
  plot.x = AxisRange{0.0, 1.03 * farthest};
  plot.y = AxisRange{0.0, 1.05 * most};
  return plot;
}

}  // namespace

void report_over(const ResultFolder& folder, const MeasureOptions& measure,
                 const LineOptions& options) {
  const PlanLine line = plan_line_of(folder, options, "over");
  const RunData run(folder, measure);
  require_near(line, run);
  std::vector<char> lies = run.lies;
  if (!run.still)
    for (char& each : lies = on_the_move(run.last.states)) each = each == 0;
  const OverLine over = over_line(line, run.blocks, run.last, lies);
  const std::vector<Beyond> rows = table_of(over);
  write_table(rows, folder);
  write_png(draw_curves(plot_of(rows, line, run)), folder.file("over.png"));
  double moved = 0.0;
  for (size_t b = 0; b < run.blocks.size(); ++b)
    if (run.moved[b] != 0) moved += run.blocks[b].volume;
  nlohmann::ordered_json keys = common_keys(folder);
  keys["over_from_x_m"] = line.from.x();
  keys["over_from_y_m"] = line.from.y();
  keys["over_to_x_m"] = line.to.x();
  keys["over_to_y_m"] = line.to.y();
  if (const std::optional<MineFrame> frame = mine_frame(folder)) {
    const Vec3 from = frame->of({line.from.x(), line.from.y(), 0.0}),
               to = frame->of({line.to.x(), line.to.y(), 0.0});
    keys["over_from_east_m"] = from.x();
    keys["over_from_north_m"] = from.y();
    keys["over_to_east_m"] = to.x();
    keys["over_to_north_m"] = to.y();
  }
  keys["over_blocks"] = over.pieces.size();
  keys["over_volume_m3"] = over.volume;
  keys["over_mass_kg"] = over.mass;
  keys["over_share_of_moved"] = moved > 0.0 ? over.volume / moved : std::nan("");
  keys["over_bulk_volume_m3"] = run.still ? bulk_beyond(line, over, run) : std::nan("");
  keys["over_farthest_m"] = over.pieces.empty() ? 0.0 : over.pieces.front().distance;
  folder.merge_into_summary(keys);
}

}  // namespace muckpile
