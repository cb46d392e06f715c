// SPDX-License-Identifier: GPL-2.0-or-later
// Sub-command movement: where the parts of a bench went, by level and by distance from the face.
// Scope: benches that profile measures; parts reach from the face to the last row of holes.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "args/input_error.h"
#include "draw/curve_plot.h"
#include "draw/png_file.h"
#include "io/csv_writer.h"
#include "io/dxf_writer.h"
#include "io/mine_frame.h"
#include "measure/columns.h"
#include "measure/movement.h"
#include "measure/ore_shares.h"
#include "measure/start_extent.h"
#include "report/bench_scene.h"
#include "report/dig_report.h"
#include "report/mine_pose.h"
#include "report/movement_table.h"
#include "report/not_measurable.h"
#include "report/ore_model_report.h"
#include "report/polygons_report.h"
#include "report/reports.h"
#include "report/run_section.h"

namespace muckpile {
namespace {

SurveyPose pose_of(const MovementOptions& options) {
  return {{options.shift[0], options.shift[1], options.shift[2]},
          options.turn_deg * std::numbers::pi / 180.0};
}

void write_table(const ResultFolder& folder, const std::vector<PartMovement>& parts) {
  const std::optional<MineFrame> frame = mine_frame(folder);
  CsvWriter csv(folder.file("movement.csv"),
                with_mine_points(std::string("level_low_m,level_high_m,from_face_m,to_face_m,") +
                                     kMovementColumns,
                                 frame, {"start_", "end_"}));
  for (const PartMovement& p : parts) {
    std::vector<double> row{p.level_low, p.level_high, p.near, p.far};
    for (const double value : movement_columns(p.rock)) row.push_back(value);
    csv.row_at(row, mine_points(frame, {p.rock.start, p.rock.end}));
  }
}

// In the axes of the polygons and models; where none are placed, in the mine's if the run knows
// them.
SurveyPose pose_of_drawing(const ResultFolder& folder, const MovementOptions& options) {
  MovementOptions own = options;
  const bool placed = own.shift != std::array<double, 3>{} || own.turn_deg != 0.0;
  if (!placed && mine_frame(folder)) set_mine_pose(folder, "movement", own.shift, own.turn_deg);
  return pose_of(own);
}

// Ways of the mass centres, a layer for each level.
void write_drawing(const std::filesystem::path& path, const std::vector<PartMovement>& parts,
                   const SurveyPose& pose) {
  DxfWriter drawing(path);
  for (const PartMovement& part : parts)
    drawing.line("level_" + std::to_string(part.level + 1), pose.back(part.rock.start),
                 pose.back(part.rock.end));
}

// From start to end with a head; a part that moved less than the head is long has none.
SectionLine arrow(const PartMovement& part, double head, const std::string& name) {
  constexpr double kWidth = 0.35;  // half the head's width over its length
  const Vec2 from(part.rock.start.x(), part.rock.start.z()),
      to(part.rock.end.x(), part.rock.end.z());
  const Vec2 way = to - from;
  SectionLine line{{from, to}, scaled(colour_of_curve(part.level), 0.8), 3.0, false, name};
  if (way.norm() <= head) return line;
  const Vec2 back = -head * way.normalized(), side = kWidth * Vec2(-back.y(), back.x());
  for (const Vec2& barb : {Vec2(to + back + side), to, Vec2(to + back - side)})
    line.points.push_back(barb);
  return line;
}

std::string level_name(const PartMovement& part) {
  return "from " + spelled(part.level_low) + " to " + spelled(part.level_high) + " m";
}

void colour_by_level(SectionPlot& plot, const std::vector<int>& levels) {
  constexpr double kPale = 0.6;  // so that arrows show on the rock
  plot.colours.map.reset();
  plot.colours.label = "colours: level before the blast";
  for (size_t b = 0; b < levels.size(); ++b)
    plot.colours.of_block[b] =
        levels[b] < 0 ? kRockInPlace : mix(colour_of_curve(levels[b]), kWhite, kPale);
}

SectionPlot section_of(const RunData& run, const BenchScene& bench, const BenchParts& parts,
                       const std::vector<PartMovement>& movement) {
  const double y = y_of_middle_hole(bench, run.blocks);
  const Extent before = extent_at_start(run.blocks);
  SectionPlot plot = section_of_run(run, y, "start_height");
  colour_by_level(plot, levels_of(run.blocks, parts));
  plot.note += ", and so is rock that started in none of the parts";
  double farthest = bench.burden;
  for (const PartMovement& part : movement) farthest = std::max(farthest, part.rock.end.x());
  plot.title = "Movement of the bench by level and distance from the face";
  plot.subtitle = "arrows: mass centres of parts of the bench, from before the blast to the end";
  plot.x_label = "distance from the toe of the free face, along the throw [m]";
  plot.x = {before.low.x() - 1.0, 1.2 * farthest + 1.0};
  plot.z = {before.low.z() - 0.5, 1.12 * bench.height};
  std::vector<Vec2> outline = face_line(bench, y);
  if (!outline.empty()) {
    outline.insert(outline.begin(), {before.low.x(), outline.front().y()});
    plot.lines.push_back({std::move(outline), kInk, 2.0, true, "bench before"});
  }
  const double head = 0.012 * (plot.x.high - plot.x.low);
  int named = -1;
  for (const PartMovement& part : movement) {
    plot.lines.push_back(arrow(part, head, part.level > named ? level_name(part) : ""));
    named = part.level;
  }
  return plot;
}

nlohmann::ordered_json keys_of(const std::vector<PartMovement>& movement) {
  nlohmann::ordered_json keys;
  keys["movement_parts"] = movement.size();
  const auto by_way = [](const PartMovement& part) { return part.rock.displacement().norm(); };
  const auto farthest = std::ranges::max_element(movement, {}, by_way);
  keys["movement_largest_m"] = farthest == movement.end() ? std::nan("") : by_way(*farthest);
  return keys;
}

BenchScene bench_or_nothing(const ResultFolder& folder, const RunData& run) {
  try {
    nlohmann::ordered_json own = keys_of({});
    for (const std::string& key : dig_keys()) own[key] = nullptr;
    return bench_or_take_back(folder, run.blocks, "movement", own);
  } catch (const NotMeasurable&) {
    write_polygons(folder, run, {}, {}, "");
    write_ore_model(folder, run, "", {});
    write_dig(folder, run, {}, {}, {});
    std::filesystem::remove(folder.file("movement.dxf"));
    throw;
  }
}

// In the run's axes.
std::vector<OrePolygon> polygons_of(const MovementOptions& options, const SurveyPose& pose) {
  std::vector<OrePolygon> polygons;
  if (options.polygons.empty()) return polygons;
  for (const OrePolygon& each : read_ore_polygons(options.polygons))
    polygons.push_back(placed(each, pose));
  return polygons;
}

}  // namespace

std::vector<double> movement_columns(const RockMovement& rock) {
  const Vec3 moved = rock.displacement();
  return {static_cast<double>(rock.blocks),
          rock.mass,
          rock.moved,
          rock.start.x(),
          rock.start.y(),
          rock.start.z(),
          rock.end.x(),
          rock.end.y(),
          rock.end.z(),
          moved.x(),
          moved.y(),
          moved.z(),
          moved.norm(),
          rock.spread};
}

void report_movement(const ResultFolder& folder, const MeasureOptions& measure,
                     const MovementOptions& options) {
  if (folder.scene_word("case") != "bench")
    refuse("movement", "the run must be a bench, got '" + folder.scene_word("case") + "'");
  const SurveyPose pose = pose_of(options);
  const std::vector<OrePolygon> polygons = polygons_of(options, pose);
  const RunData run(folder, measure);
  const BenchScene bench = bench_or_nothing(folder, run);
  const BenchParts parts{bench.height, bench.depth, options.levels, options.distances,
                         bench.planes};
  const std::vector<PartMovement> movement =
      movement_of_parts(run.blocks, run.last, run.moved, parts);
  if (movement.empty())
    refuse("movement", "no block started between the face and the last row of holes");
  write_polygons(folder, run, polygons, pose, options.polygons);
  const nlohmann::ordered_json of_model = write_ore_model(folder, run, options.model, pose);
  write_table(folder, movement);
  write_drawing(folder.file("movement.dxf"), movement, pose_of_drawing(folder, options));
  write_png(draw_section(section_of(run, bench, parts, movement)), folder.file("movement.png"));
  nlohmann::ordered_json keys = common_keys(folder);
  keys.update(keys_of(movement));
  keys.update(of_model);
  keys.update(write_dig(folder, run, options, polygons, pose));
  std::vector<std::string> dropped = dig_keys();
  for (const std::string& key :
       {refusal_key("movement"), std::string("model_cells"), std::string("model_cells_in_blocks")})
    dropped.push_back(key);
  folder.merge_into_summary(keys, dropped);
}

}  // namespace muckpile
