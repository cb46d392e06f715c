// SPDX-License-Identifier: GPL-2.0-or-later
// Polygons of ore carried into the pile.
// Scope: see the header.
#include "report/polygons_report.h"

#include "args/input_error.h"
#include "draw/curve_plot.h"
#include "draw/png_file.h"
#include "io/csv_writer.h"
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

CarriedPolygon carried(const OrePolygon& polygon, const RunData& run) {
  std::vector<size_t> chosen;
  for (size_t b = 0; b < run.blocks.size(); ++b) {
    if (polygon.contains(run.blocks[b].centroid)) chosen.push_back(b);
  }
  if (chosen.empty())
    refuse("movement: polygon '" + polygon.name + "'", "no block's centroid started in it");
  return {polygon, chosen, dug_polygon(polygon, chosen, run.blocks, run.last, run.moved)};
}

void write_tables(const ResultFolder& folder, const std::vector<CarriedPolygon>& polygons) {
  CsvWriter table(folder.file("polygons.csv"), std::string("polygon,") + kMovementColumns +
                                                   ",recovered_fraction,dilution_fraction");
  CsvWriter outlines(folder.file("polygons_moved.csv"), "polygon,x_m,y_m");
  for (const CarriedPolygon& each : polygons) {
    std::vector<double> row = movement_columns(each.dug.rock);
    row.push_back(each.dug.recovered);
    row.push_back(each.dug.dilution);
    table.row(each.start.name, row);
    for (const Vec2& corner : each.dug.outline)
      outlines.row(each.start.name, {corner.x(), corner.y()});
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
                    const std::vector<OrePolygon>& polygons) {
  if (polygons.empty()) {
    for (const char* ending : {".csv", "_moved.csv", ".png"})
      std::filesystem::remove(folder.file(std::string("polygons") + ending));
    return;
  }
  std::vector<CarriedPolygon> all;
  for (const OrePolygon& polygon : polygons) all.push_back(carried(polygon, run));
  write_tables(folder, all);
  write_png(draw_curves(plot_of(all, run)), folder.file("polygons.png"));
}

}  // namespace muckpile
