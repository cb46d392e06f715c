// SPDX-License-Identifier: GPL-2.0-or-later
// Polygons of ore carried into the pile.
// Scope: see the header.
#include "report/polygons_report.h"

#include "args/input_error.h"
#include "draw/curve_plot.h"
#include "draw/png_file.h"
#include "io/csv_writer.h"
#include "io/dxf_writer.h"
#include "io/mine_frame.h"
#include "measure/dug_polygon.h"
#include "report/movement_table.h"
#include "report/notes.h"

namespace muckpile {
namespace {

struct CarriedPolygon {
  OrePolygon start;
  std::vector<size_t> chosen;
  DugPolygon dug;
};

CarriedPolygon carried(const OrePolygon& polygon, const RunData& run, const std::string& file) {
  std::vector<size_t> chosen;
  for (size_t b = 0; b < run.blocks.size(); ++b) {
    if (polygon.contains(run.blocks[b].centroid)) chosen.push_back(b);
  }
  if (chosen.empty())
    refuse(file, "no block's centroid started in polygon '" + polygon.name +
                     "'; see its place (--shift, --turn, --mine) and heights");
  return {polygon, chosen, dug_polygon(polygon, chosen, run.blocks, run.last, run.moved)};
}

// Corners in the run's axes, at a height of them, in those of the polygons.
std::vector<Vec3> in_file(const std::vector<Vec2>& corners, double z, const SurveyPose& pose) {
  std::vector<Vec3> places;
  for (const Vec2& corner : corners) places.push_back(pose.back({corner.x(), corner.y(), z}));
  return places;
}

// At the heights of the rock's mass centre, before the blast and after.
void write_drawing(const std::filesystem::path& path, const std::vector<CarriedPolygon>& polygons,
                   const SurveyPose& pose) {
  constexpr double kLetters = 0.5;  // [m]
  DxfWriter drawing(path);
  for (const CarriedPolygon& each : polygons) {
    const RockMovement& rock = each.dug.rock;
    drawing.outline(each.start.name + "_before", in_file(each.start.corners, rock.start.z(), pose));
    drawing.outline(each.start.name + "_after", in_file(each.dug.outline, rock.end.z(), pose));
    drawing.text(each.start.name + "_after", pose.back(rock.end), kLetters, each.start.name);
    drawing.line(each.start.name + "_way", pose.back(rock.start), pose.back(rock.end));
  }
}

void write_tables(const ResultFolder& folder, const std::vector<CarriedPolygon>& polygons,
                  const SurveyPose& pose) {
  const std::optional<MineFrame> frame = mine_frame(folder);
  CsvWriter table(
      folder.file("polygons.csv"),
      with_mine_points(
          joined({"polygon", kMovementColumns, "recovered_fraction", "dilution_fraction"}, ","),
          frame, {"start_", "end_"}));
  CsvWriter outlines(folder.file("polygons_moved.csv"), "polygon,x_m,y_m");
  for (const CarriedPolygon& each : polygons) {
    std::vector<double> row = movement_columns(each.dug.rock);
    row.push_back(each.dug.recovered);
    row.push_back(each.dug.dilution);
    table.row_at(each.start.name, row,
                 mine_points(frame, {each.dug.rock.start, each.dug.rock.end}));
    for (const Vec3& corner : in_file(each.dug.outline, 0.0, pose))
      outlines.row(
          std::vector<std::string>{each.start.name, place_text(corner.x()), place_text(corner.y())},
          {});
  }
}

std::vector<Vec2> closed(std::vector<Vec2> corners) {
  corners.push_back(corners.front());
  return corners;
}

CurvePlot plot_of(const std::vector<CarriedPolygon>& polygons, const RunData& run) {
  CurvePlot plot;
  plot.title = "Polygons before the blast (dashed) and carried by their rock";
  plot.x_label = "x, along the throw [m]";
  plot.y_label = "y [m]";
  plot.one_scale = true;
  plot.warning = motion_warning(run.still);
  int colour = 0;
  for (const CarriedPolygon& each : polygons) {
    PlotCurve blocks{each.start.name + ": its blocks at the end", CurveStyle::kPoints, colour, {}};
    for (const size_t b : each.chosen)
      blocks.points.emplace_back(run.last.states[b].centre.head<2>());
    plot.curves.push_back(std::move(blocks));
    plot.curves.push_back({"", CurveStyle::kDashed, colour, closed(each.start.corners)});
    plot.curves.push_back({"", CurveStyle::kLine, colour, closed(each.dug.outline)});
    ++colour;
  }
  return plot;
}

}  // namespace

void write_polygons(const ResultFolder& folder, const RunData& run,
                    const std::vector<OrePolygon>& polygons, const SurveyPose& pose,
                    const std::string& file) {
  if (polygons.empty()) {
    for (const char* ending : {".csv", "_moved.csv", ".png", ".dxf"})
      std::filesystem::remove(folder.file(std::string("polygons") + ending));
    return;
  }
  std::vector<CarriedPolygon> all;
  for (const OrePolygon& polygon : polygons) all.push_back(carried(polygon, run, file));
  write_tables(folder, all, pose);
  write_drawing(folder.file("polygons.dxf"), all, pose);
  write_png(draw_curves(plot_of(all, run)), folder.file("polygons.png"));
}

}  // namespace muckpile
