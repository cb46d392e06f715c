// SPDX-License-Identifier: GPL-2.0-or-later
// Velocity of the free face over height.
// Scope: see the header.
#include "report/face_bands.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "draw/curve_plot.h"
#include "draw/png_file.h"
#include "io/csv_writer.h"
#include "report/notes.h"

namespace muckpile {
namespace {

CurvePlot face_plot(const std::vector<FaceBand>& bands, bool still) {
  CurvePlot plot;
  plot.x_label = "largest outward velocity over the snapshots [m/s]";
  plot.y_label = "height above the floor [m]";
  plot.warning = motion_warning(still);
  double fastest = 1.0, top = 0.0;  // a face that stands still has a scale, too [m/s], [m]
  for (const FaceBand& band : bands) {
    if (plot.curves.empty() || plot.curves.back().label != band.name) {
      const bool all = band.name == "all";
      plot.curves.push_back({band.name,
                             all ? CurveStyle::kDashed : CurveStyle::kLine,
                             static_cast<int>(plot.curves.size()),
                             {}});
    }
    fastest = std::fmax(fastest, band.peak);
    top = std::max(top, band.high);
    if (!std::isnan(band.peak))
      plot.curves.back().points.emplace_back(band.peak, 0.5 * (band.low + band.high));
  }
  if (plot.curves.size() == 1) {  // nothing to tell apart
    plot.curves.front().label.clear();
    plot.curves.front().style = CurveStyle::kLine;
  }
  plot.title = plot.curves.size() > 1
                   ? "Face velocity over height, in front of each hole of the first row"
                   : "Face velocity over height";
  plot.x = AxisRange{0.0, 1.05 * fastest};
  plot.y = AxisRange{0.0, top};
  return plot;
}

}  // namespace

void add_velocity(FaceBand& band, const std::vector<StartBlock>& blocks, const Snapshot& now,
                  const BenchPlanes& planes) {
  if (band.layer.empty()) return;
  const double velocity = mean_outward_velocity(blocks, now, band.layer, planes);
  if (velocity <= band.peak) return;
  band.peak = velocity;
  band.time = now.time;
}

void write_face_bands(const ResultFolder& folder, const std::vector<FaceBand>& bands, bool still) {
  CsvWriter face(folder.file("face_velocity.csv"),
                 "hole,height_low_m,height_high_m,velocity_m_s,velocity_at_s");
  for (const FaceBand& band : bands)
    face.row(band.name, {band.low, band.high, band.peak, band.time});
  write_png(draw_curves(face_plot(bands, still)), folder.file("face_velocity.png"));
}

void remove_face_bands(const ResultFolder& folder) {
  for (const char* ending : {".csv", ".png"})
    std::filesystem::remove(folder.file(std::string("face_velocity") + ending));
}

}  // namespace muckpile
