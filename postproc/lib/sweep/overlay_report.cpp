// SPDX-License-Identifier: GPL-2.0-or-later
// Sub-command overlay.
// Scope: see the header.
#include "sweep/overlay_report.h"

#include <algorithm>

#include "args/input_error.h"
#include "args/suggestion.h"
#include "draw/panels.h"
#include "draw/png_file.h"
#include "io/csv_writer.h"
#include "sweep/overlay.h"
#include "sweep/sweep_plot.h"

namespace muckpile {
namespace {

void write_curves(const OverlaidCurves& all, const std::filesystem::path& path) {
  CsvWriter csv(path,
                "column," + all.over + ",runs,mean,standard_deviation,least,p10,p50,p90,largest");
  for (const OverlaidCurve& curve : all.curves)
    for (size_t k = 0; k < curve.x.size(); ++k) {
      const Spread& s = curve.spread[k];
      csv.row(curve.column, {curve.x[k], static_cast<double>(s.count), s.mean, s.deviation, s.least,
                             s.p10, s.p50, s.p90, s.largest});
    }
}

void write_rows(const OverlaidRows& all, const std::filesystem::path& path) {
  CsvWriter csv(path, joined(all.over, ",") +
                          ",column,runs,mean,standard_deviation,least,p10,p50,p90,largest");
  for (const OverlaidRow& row : all.rows) {
    std::vector<std::string> words = row.names;
    words.push_back(row.column);
    const Spread& s = row.spread;
    csv.row(words, {static_cast<double>(s.count), s.mean, s.deviation, s.least, s.p10, s.p50, s.p90,
                    s.largest});
  }
}

// Around the area from P10 to P90.
PlotCurve band_of(const OverlaidCurve& curve) {
  PlotCurve band{"P10 to P90", CurveStyle::kBand, 0, {}};
  for (size_t k = 0; k < curve.x.size(); ++k)
    band.points.emplace_back(curve.x[k], curve.spread[k].p10);
  for (size_t k = curve.x.size(); k-- > 0;)
    band.points.emplace_back(curve.x[k], curve.spread[k].p90);
  return band;
}

// Of many runs, whose lines would hide an area.
PlotCurve edge_of(const OverlaidCurve& curve, double Spread::*quantile, std::string label) {
  PlotCurve edge{std::move(label), CurveStyle::kThin, 0, {}};
  for (size_t k = 0; k < curve.x.size(); ++k)
    edge.points.emplace_back(curve.x[k], curve.spread[k].*quantile);
  return edge;
}

CurvePlot plot_of(const OverlaidCurve& curve, const std::string& over,
                  const std::vector<std::string>& runs) {
  constexpr size_t kNamed = 6;  // more runs are thin lines of one colour
  constexpr int kGrey = 6;
  CurvePlot plot;
  plot.x_label = name_of_figure(over);
  plot.y_label = name_of_figure(curve.column);
  if ((over == "sieve_m" || over == "size_m") && curve.x.front() > 0.0)
    plot.x_scale = Scale::kLogarithmic;
  const bool named = runs.size() <= kNamed;
  if (runs.size() > 2 && named) plot.curves.push_back(band_of(curve));
  for (size_t k = 0; k < runs.size(); ++k) {
    plot.curves.push_back({named    ? runs[k]
                           : k == 0 ? "each run"
                                    : "",
                           CurveStyle::kThin, named ? static_cast<int>(k + 1) : kGrey,
                           curve.runs[k]});
  }
  if (!named) {
    plot.curves.push_back(edge_of(curve, &Spread::p10, "P10 and P90"));
    plot.curves.push_back(edge_of(curve, &Spread::p90, ""));
  }
  PlotCurve middle{"P50", CurveStyle::kLine, 0, {}};
  for (size_t k = 0; k < curve.x.size(); ++k)
    middle.points.emplace_back(curve.x[k], curve.spread[k].p50);
  if (runs.size() > 2) plot.curves.push_back(middle);
  return plot;
}

// A frame per column: of each row P50, and a bar from P10 to P90.
std::vector<CurvePlot> row_plots(const OverlaidRows& all) {
  std::vector<std::string> rows;  // "1 2" for the row of level 1 and band 2, say
  std::vector<CurvePlot> plots;
  std::vector<std::string> columns;
  for (const OverlaidRow& row : all.rows) {
    const std::string name = joined(row.names, " ");
    auto place = std::ranges::find(rows, name);
    if (place == rows.end()) place = rows.insert(rows.end(), name);
    const auto x = static_cast<double>(place - rows.begin() + 1);
    auto column = std::ranges::find(columns, row.column);
    if (column == columns.end()) {
      column = columns.insert(columns.end(), row.column);
      plots.emplace_back();
      plots.back().y_label = name_of_figure(row.column);
      plots.back().curves.push_back(
          {"P50, and bars from P10 to P90", CurveStyle::kPoints, 0, {}, {}});
    }
    const Spread& s = row.spread;
    if (s.count == 0) continue;
    PlotCurve& curve = plots[static_cast<size_t>(column - columns.begin())].curves.front();
    curve.points.emplace_back(x, s.p50);
    curve.bars.push_back({x, s.p10, s.p90});
  }
  constexpr size_t kLetters = 36;  // fit below a frame
  size_t letters = 0;
  for (const std::string& row : rows) letters += row.size() + 2;
  for (CurvePlot& plot : plots) {
    plot.x = {0.5, static_cast<double>(rows.size()) + 0.5};
    if (letters <= kLetters) plot.x_words = rows;
    plot.x_label = letters <= kLetters ? joined(all.over, ", ") : "number of the row in the table";
  }
  return plots;
}

std::vector<std::string> names_of(const std::vector<std::string>& runs) {
  std::vector<std::string> names;
  for (const std::string& run : runs) {
    const std::filesystem::path path = std::filesystem::path(run).lexically_normal();
    names.push_back((path.has_filename() ? path : path.parent_path()).filename().string());
  }
  return names;
}

}  // namespace

std::vector<std::filesystem::path> report_overlay(const OverlayOptions& options) {
  if (options.runs.size() < 2)
    refuse("overlay", "needs two runs at least, got " + std::to_string(options.runs.size()));
  if (!std::filesystem::is_directory(options.out))
    refuse("overlay", "--out must be a folder that exists, got '" + options.out + "'");
  std::vector<std::filesystem::path> tables;
  for (const std::string& run : options.runs)
    tables.push_back(std::filesystem::path(run) / options.table);
  const std::filesystem::path base =
      std::filesystem::path(options.out) /
      ("overlay_" + std::filesystem::path(options.table).stem().string());
  const std::filesystem::path csv = base.string() + ".csv", png = base.string() + ".png";
  Panels panels;
  panels.title = options.table + " of " + std::to_string(options.runs.size()) + " runs";
  if (has_named_rows(tables.front())) {
    const OverlaidRows all = overlaid_rows(tables, options.columns);
    write_rows(all, csv);
    panels.plots = row_plots(all);
    if (panels.plots.empty()) return {csv};
    write_png(draw_panels(panels), png);
    return {csv, png};
  }
  const OverlaidCurves all = overlaid_curves(tables, options.columns);
  write_curves(all, csv);
  for (const OverlaidCurve& curve : all.curves)
    panels.plots.push_back(plot_of(curve, all.over, names_of(options.runs)));
  write_png(draw_panels(panels), png);
  return {csv, png};
}

}  // namespace muckpile
