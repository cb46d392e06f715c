// SPDX-License-Identifier: GPL-2.0-or-later
// Where the surface of the pile lies in a tenth, half and nine tenths of the runs of a sweep.
// Scope: see the header.
#include "sweep/profile_bands.h"

#include "compare/table_curves.h"
#include "draw/curve_plot.h"
#include "draw/png_file.h"
#include "io/csv_writer.h"
#include "sweep/spread.h"

namespace muckpile {
namespace {

constexpr size_t kFewest = 3;
constexpr const char* kHeight = "pile_mean_m";

std::vector<std::vector<Vec2>> surfaces_of(const Sweep& sweep) {
  std::vector<std::vector<Vec2>> surfaces;
  for (const SweepRun& run : sweep.runs) {
    const std::filesystem::path file = sweep.folder / run.folder / "profile.csv";
    if (!run.is_done() || !std::filesystem::exists(file)) continue;
    const TableCurves curves = read_curves(file);
    const auto found = curves.of_column.find(kHeight);
    if (found != curves.of_column.end() && !found->second.empty())
      surfaces.push_back(found->second);
  }
  return surfaces;
}

}  // namespace

std::vector<ProfileBand> profile_bands(const Sweep& sweep) {
  const std::vector<std::vector<Vec2>> surfaces = surfaces_of(sweep);
  if (surfaces.size() < kFewest) return {};
  const auto& widest =
      *std::ranges::max_element(surfaces, {}, [](const auto& curve) { return curve.back().x(); });
  std::vector<ProfileBand> bands;
  for (const Vec2& place : widest) {
    std::vector<double> heights;
    for (const auto& surface : surfaces) heights.push_back(value_at(surface, place.x()));
    const Spread spread = spread_of(heights);
    bands.push_back({place.x(), spread.p10, spread.p50, spread.p90});
  }
  return bands;
}

std::vector<std::filesystem::path> write_profile_bands(const Sweep& sweep,
                                                       const std::vector<ProfileBand>& bands) {
  const std::filesystem::path table = sweep.folder / "profile_bands.csv",
                              picture = sweep.folder / "profile_bands.png";
  std::filesystem::remove(table);
  std::filesystem::remove(picture);
  if (bands.empty()) return {};
  CsvWriter csv(table, "x_m,p10_m,p50_m,p90_m");
  CurvePlot plot;
  plot.title = "Surface of the pile over all runs";
  plot.x_label = "distance from the free face, along the throw [m]";
  plot.y_label = "height, mean over the width [m]";
  plot.curves = {{"P90", CurveStyle::kDashed, 0, {}, {}},
                 {"P50", CurveStyle::kLine, 1, {}, {}},
                 {"P10", CurveStyle::kDashed, 2, {}, {}}};
  for (const ProfileBand& band : bands) {
    csv.row({band.x, band.p10, band.p50, band.p90});
    plot.curves[0].points.emplace_back(band.x, band.p90);
    plot.curves[1].points.emplace_back(band.x, band.p50);
    plot.curves[2].points.emplace_back(band.x, band.p10);
  }
  write_png(draw_curves(plot), picture);
  return {table, picture};
}

}  // namespace muckpile
