// SPDX-License-Identifier: GPL-2.0-or-later
// Sub-command crater: section, ring profile, launch and measures of a crater and its ejecta.
// Scope: free surface z = 0, charge on the z axis.
#include <algorithm>
#include <cmath>
#include <limits>

#include "args/input_error.h"
#include "draw/png_file.h"
#include "io/charges.h"
#include "io/csv_writer.h"
#include "io/snapshot_reader.h"
#include "measure/columns.h"
#include "measure/crater.h"
#include "measure/launch.h"
#include "measure/start_extent.h"
#include "report/burial_depth.h"
#include "report/not_measurable.h"
#include "report/reports.h"
#include "report/run_section.h"

namespace muckpile {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

void write_rings(const std::vector<CraterRing>& rings, const std::filesystem::path& path) {
  CsvWriter csv(path, "radius_m,surface_after_m,rock_in_place_m,broken_fraction_of_surface");
  for (const CraterRing& ring : rings)
    csv.row({ring.radius, ring.surface, ring.true_surface, ring.moved_fraction});
}

// Of every snapshot, ring by ring of a quarter of the burial depth.
void write_launch(const ResultFolder& folder, const RunData& run,
                  const std::filesystem::path& path) {
  const std::vector<SurfaceRing> rings = surface_rings(run.blocks, 0.25 * burial_depth(folder));
  CsvWriter csv(path, "time_s,start_radius_m,outward_m_s,upward_m_s,mass_kg");
  SnapshotReader reader(folder.blocks());
  for (const auto& file : folder.snapshots()) {
    const Snapshot& snapshot = reader.read(file);
    for (const SurfaceRing& ring : rings) {
      const RingVelocity mean = velocity_of(ring, run.blocks, snapshot);
      csv.row({snapshot.time, ring.radius, mean.outward, mean.upward, ring.mass});
    }
  }
}

nlohmann::ordered_json crater_keys(const CraterShape& apparent, const CraterShape& whole,
                                   const Ejecta& ejecta) {
  nlohmann::ordered_json keys;
  keys["crater_radius_m"] = whole.radius;
  keys["crater_depth_m"] = whole.depth;
  keys["crater_volume_m3"] = whole.volume;
  keys["apparent_crater_radius_m"] = apparent.radius;
  keys["apparent_crater_depth_m"] = apparent.depth;
  keys["apparent_crater_volume_m3"] = apparent.volume;
  keys["ejecta_mass_kg"] = ejecta.mass;
  keys["ejecta_p50_m"] = ejecta.p50;
  keys["ejecta_p90_m"] = ejecta.p90;
  keys["ejecta_max_m"] = ejecta.max;
  return keys;
}

// Ring means on both sides of the axis.
std::vector<Vec2> both_sides(const std::vector<CraterRing>& rings, double CraterRing::*height) {
  std::vector<Vec2> points;
  for (auto ring = rings.rbegin(); ring != rings.rend(); ++ring)
    points.emplace_back(-ring->radius, (*ring).*height);
  for (const CraterRing& ring : rings) points.emplace_back(ring.radius, ring.*height);
  return points;
}

SectionPlot section_of(const ResultFolder& folder, const RunData& run,
                       const std::vector<CraterRing>& rings, const CraterShape& apparent,
                       const CraterShape& whole, const SectionOptions& options) {
  // Blocks of a model with a symmetry plane end at y = 0: they are cut beside it.
  constexpr double kBeside = 0.1;  // of a block: beside the crack that often runs there
  const double y = options.y.value_or(folder.symmetry() > 1 ? kBeside * run.block_size : 0.0);
  const double burial = burial_depth(folder);
  const Extent before = extent_at_start(run.blocks);
  const double reach = std::max(std::abs(before.low.x()), before.high.x());
  double top = 0.5 * burial;
  for (const CraterRing& ring : rings) top = std::max(top, ring.surface + 0.5 * burial);
  SectionPlot plot = section_of_run(run, y, options.colour_by);
  plot.title = "Crater";
  plot.x_label = "distance from the charge axis [m]";
  plot.x = {-reach, reach};
  plot.z = {before.low.z(), top};
  if (folder.scene_has("charge_mass_kg"))
    plot.title += ": charge " + spelled(folder.scene_number("charge_mass_kg")) + " kg";
  plot.title += ", burial depth " + spelled(burial) + " m";
  const auto dimensions = [](const CraterShape& shape) {
    return spelled(shape.radius) + " m radius, " + spelled(shape.depth) + " m deep, " +
           spelled(shape.volume) + " m³";
  };
  plot.subtitle = run.still
                      ? "dug out: " + dimensions(whole) + " · apparent: " + dimensions(apparent)
                      : "dug out so far: " + dimensions(whole);
  plot.lines = {
      {{{-reach, 0.0}, {reach, 0.0}}, kBench, 2.5, true, "surface before"},
      {both_sides(rings, &CraterRing::surface), kSignal, 3.0, false,
       "surface after, mean over rings"},
      {both_sides(rings, &CraterRing::true_surface), kInk, 2.5, true, "rock that stayed"}};
  const double half =
      folder.scene_has("hole_diameter_m") ? 0.5 * folder.scene_number("hole_diameter_m") : 0.1;
  plot.bars = {{{0.0, -burial - half}, {0.0, -burial + half}, half, kSignal, "charge before"}};
  return plot;
}

// Rings about the z axis are those of a charge on it.
void require_charge_on_axis(const ResultFolder& folder) {
  constexpr double kOff = 0.05;  // of the burial depth
  for (const Charge& charge : charges_of_run(folder)) {
    for (const Vec3& end : {charge.toe, charge.collar}) {
      if (end.head<2>().norm() <= kOff * burial_depth(folder)) continue;
      const NotMeasurable refusal(
          "crater: the charge must stand on the z axis, got one through x = " + spelled(end.x()) +
          ", y = " + spelled(end.y()) + " m; the crater is not measured");
      nlohmann::ordered_json own = crater_keys({}, {}, {});
      own["blocks_on_the_move"] = nullptr;
      own["blocks_in_blocks"] = nullptr;
      std::filesystem::remove(folder.file("launch.csv"));
      take_back(folder, "crater", own, refusal);
      throw refusal;
    }
  }
}

}  // namespace

void report_crater(const ResultFolder& folder, const MeasureOptions& measure,
                   const SectionOptions& section) {
  if (folder.scene_word("case") == "bench") {
    refuse_to_measure(folder, "crater",
                      "the run must be a crater, got 'bench'; use the sub-command profile");
  }
  require_charge_on_axis(folder);
  // The rock of a crater is graded from fine at the charge to coarse far away: a block that has
  // moved by its own size is loose, whatever the mean of all is.
  MeasureOptions own = measure;
  own.least_move = measure.least_move.value_or(0.0);
  const RunData run(folder, own);
  const std::vector<CraterRing> rings =
      crater_rings(run.blocks, run.last, run.moved, run.cell, run.block_size, run.lies);
  const CraterShape whole = true_crater(rings);
  CraterShape apparent = apparent_crater(rings);
  Ejecta ejecta =
      ejecta_beyond(std::max(apparent.radius, whole.radius), run.blocks, run.last, run.moved);
  // What flies has not landed: where, and what of it falls back into the crater, is open. What has
  // been broken out stays so.
  if (!run.still) {
    apparent = {kNone, kNone, kNone};
    ejecta = {kNone, kNone, kNone, kNone};
  }
  SectionPlot plot = section_of(folder, run, rings, apparent, whole, section);
  write_rings(rings, folder.file("crater.csv"));
  write_launch(folder, run, folder.file("launch.csv"));
  write_png(draw_section(std::move(plot)), folder.file("crater.png"));
  nlohmann::ordered_json keys = common_keys(folder);
  keys.update(crater_keys(apparent, whole, ejecta));
  keys["blocks_on_the_move"] = std::ranges::count(run.lies, 0);
  keys["blocks_in_blocks"] = run.blocks_in_blocks();
  folder.merge_into_summary(keys, {refusal_key("crater")});
}

}  // namespace muckpile
