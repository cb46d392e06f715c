// SPDX-License-Identifier: GPL-2.0-or-later
// Sub-command damage: how far from the charges the joints are broken at the end.
// Scope: see the header.
#include "report/damage_report.h"

#include <cmath>
#include <limits>

#include "draw/curve_plot.h"
#include "draw/png_file.h"
#include "explosive/hole_table.h"
#include "io/charges.h"
#include "io/csv_writer.h"
#include "io/fired_charges.h"
#include "io/muck.h"
#include "measure/broken_out.h"
#include "measure/damage.h"
#include "report/not_measurable.h"
#include "report/reports.h"

namespace muckpile {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kHalf = 0.5, kTenth = 0.1;

std::vector<FiredCharge> axes_of(const ResultFolder& folder) {
  if (charges_of_run(folder).empty() && !std::filesystem::exists(folder.dump("holes.csv")))
    throw NotMeasurable("damage: the run has no charges: no holes in " +
                        folder.dump("run.json").string());
  std::vector<FiredCharge> axes;
  for (const Charge& charge : charges_of(folder))
    axes.push_back({charge.toe, charge.collar, kNaN, kNaN});
  return axes;
}

// Of the scene, else of the first charge of the hole table; NaN where neither tells [m].
double hole_radius(const ResultFolder& folder) {
  if (folder.scene_has("hole_diameter_m")) return 0.5 * folder.scene_number("hole_diameter_m");
  const std::filesystem::path path = folder.dump("holes.csv");
  if (!std::filesystem::exists(path)) return kNaN;
  const HoleTable table = HoleTable::read(path.string());
  return table.decks().empty() ? kNaN : 0.5 * table.decks().front().diameter;
}

std::vector<DamagedBlock> damaged_blocks(const std::vector<StartBlock>& blocks,
                                         const Snapshot& last,
                                         const std::vector<FiredCharge>& axes) {
  std::vector<DamagedBlock> damaged;
  for (size_t b = 0; b < blocks.size(); ++b)
    damaged.push_back({distance_to_charges(blocks[b].centroid, axes), blocks[b].volume,
                       last.states[b].broken_fraction});
  return damaged;
}

struct Damage {
  std::vector<DamageRing> rings;
  double hole_radius = kNaN;         // [m]
  double half = kNaN, tenth = kNaN;  // radii where the share falls below these [m]
};

void write_table(const Damage& damage, const std::filesystem::path& path) {
  CsvWriter csv(path, "distance_m,distance_hole_radii,blocks,volume_m3,broken_fraction");
  for (const DamageRing& ring : damage.rings)
    csv.row({ring.distance, ring.distance / damage.hole_radius, static_cast<double>(ring.blocks),
             ring.volume, ring.broken_fraction});
}

Canvas draw_damage(const Damage& damage) {
  CurvePlot plot;
  plot.title = "Broken joints around the charges";
  plot.x_label = "distance from the nearest charge [m]";
  plot.y_label = "broken share of joint area";
  plot.y = AxisRange{-0.02, 1.04};
  PlotCurve shares{"share", CurveStyle::kLineAndPoints, 0, {}};
  for (const DamageRing& ring : damage.rings)
    shares.points.emplace_back(ring.distance, ring.broken_fraction);
  plot.curves.push_back(std::move(shares));
  int colour = 1;
  for (const auto& [radius, level] :
       {std::pair(damage.half, kHalf), std::pair(damage.tenth, kTenth)}) {
    if (std::isnan(radius)) continue;
    std::string label = "below " + spelled(level) + " from " + spelled(radius) + " m on";
    if (!std::isnan(damage.hole_radius))
      label += ", " + spelled(radius / damage.hole_radius) + " hole radii";
    plot.curves.push_back({label, CurveStyle::kDashed, colour++, {{radius, 0.0}, {radius, 1.0}}});
  }
  return draw_curves(plot);
}

nlohmann::ordered_json keys_of(const Damage& damage) {
  nlohmann::ordered_json keys;
  keys["damage_half_radius_m"] = damage.half;
  keys["damage_tenth_radius_m"] = damage.tenth;
  keys["damage_half_hole_radii"] = damage.half / damage.hole_radius;
  keys["damage_tenth_hole_radii"] = damage.tenth / damage.hole_radius;
  keys["damage_note"] = nullptr;
  if (std::isnan(damage.half) || std::isnan(damage.tenth))
    keys["damage_note"] =
        "null: no ring has so large a share, or the outermost ring of the model still has it";
  return keys;
}

Damage measured(const ResultFolder& folder, const DamageOptions& options) {
  const std::vector<FiredCharge> axes = axes_of(folder);
  const std::vector<StartBlock>& blocks = folder.rock();
  Snapshot last = read_snapshot(folder.snapshots().back(), folder.blocks());
  (void)split_muck(last.states, blocks.size());
  const double width =
      options.bin.value_or(mean_block_size(blocks, std::vector<char>(blocks.size(), 1)));
  Damage damage{damage_rings(damaged_blocks(blocks, last, axes), width), hole_radius(folder)};
  damage.half = damage_radius(damage.rings, kHalf).value_or(kNaN);
  damage.tenth = damage_radius(damage.rings, kTenth).value_or(kNaN);
  return damage;
}

}  // namespace

void report_damage(const ResultFolder& folder, const DamageOptions& options) {
  try {
    const Damage damage = measured(folder, options);
    write_table(damage, folder.file("damage.csv"));
    write_png(draw_damage(damage), folder.file("damage.png"));
    nlohmann::ordered_json keys = common_keys(folder);
    keys.update(keys_of(damage));
    folder.merge_into_summary(keys, {refusal_key("damage")});
  } catch (const NotMeasurable& why) {
    take_back(folder, "damage", keys_of({}), why);
    throw;
  }
}

}  // namespace muckpile
