// SPDX-License-Identifier: GPL-2.0-or-later
// Sub-command damage: how far from the charges the joints are broken at the end.
// Scope: see the header.
#include "report/damage_report.h"

#include <cmath>
#include <limits>

#include "draw/curve_plot.h"
#include "draw/png_file.h"
#include "io/charges.h"
#include "io/csv_writer.h"
#include "io/fired_charges.h"
#include "io/images.h"
#include "io/muck.h"
#include "measure/broken_out.h"
#include "measure/damage.h"
#include "report/cracks_of_run.h"
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
  if (!std::filesystem::exists(folder.dump("holes.csv"))) return kNaN;
  const HoleTable table = hole_table_of(folder);
  return table.decks().empty() ? kNaN : 0.5 * table.decks().front().diameter;
}

// Images behind symmetry planes are as their blocks are.
std::vector<DamagedBlock> damaged_blocks(const std::vector<StartBlock>& blocks,
                                         const Snapshot& last, const std::vector<FiredCharge>& axes,
                                         const std::optional<CracksOfRun>& cracks) {
  const size_t model = modelled(blocks);
  const std::vector<double> connected =
      cracks ? cracks->connected_of_blocks(model) : std::vector<double>(model, kNaN);
  std::vector<DamagedBlock> damaged;
  for (size_t b = 0; b < blocks.size(); ++b)
    damaged.push_back({distance_to_charges(blocks[b].centroid, axes), blocks[b].volume,
                       last.states[b].broken_fraction, connected[b % model]});
  return damaged;
}

struct Damage {
  std::vector<DamageRing> rings;
  double hole_radius = kNaN;            // [m]
  double half = kNaN, tenth = kNaN;     // radii where the share falls below these [m]
  std::optional<CracksOfRun> cracks{};  // none: not known which joints hold
};

void write_table(const Damage& damage, const std::filesystem::path& path) {
  CsvWriter csv(
      path, "distance_m,distance_hole_radii,blocks,volume_m3,broken_fraction,connected_fraction");
  for (const DamageRing& ring : damage.rings)
    csv.row({ring.distance, ring.distance / damage.hole_radius, static_cast<double>(ring.blocks),
             ring.volume, ring.broken_fraction, ring.connected_fraction});
}

PlotCurve connected_shares(const Damage& damage, int colour) {
  PlotCurve shares{"in cracks from a hole on", CurveStyle::kLineAndPoints, colour, {}};
  for (const DamageRing& ring : damage.rings)
    shares.points.emplace_back(ring.distance, ring.connected_fraction);
  return shares;
}

Canvas draw_damage(const Damage& damage) {
  CurvePlot plot;
  plot.title = "Broken joints around the charges";
  plot.x_label = "distance from the nearest charge [m]";
  plot.y_label = "broken share of joint area";
  plot.y = AxisRange{-0.02, 1.04};
  PlotCurve shares{"all", CurveStyle::kLineAndPoints, 0, {}};
  for (const DamageRing& ring : damage.rings)
    shares.points.emplace_back(ring.distance, ring.broken_fraction);
  plot.curves.push_back(std::move(shares));
  int colour = 1;
  if (damage.cracks) plot.curves.push_back(connected_shares(damage, colour++));
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

// Keys of the cracks; null where they are not known.
void add_crack_keys(const Damage& damage, nlohmann::ordered_json& keys) {
  const auto& cracks = damage.cracks;
  const auto reach = [&](double share) {
    return cracks ? reach_exceeded(cracks->reaches, share) : kNaN;
  };
  const auto beyond = [&](double radii) {
    return cracks ? directions_beyond(cracks->reaches, radii * damage.hole_radius) : kNaN;
  };
  for (const auto& [name, share] :
       {std::pair("half", kHalf), std::pair("tenth", kTenth), std::pair("farthest", 0.0)}) {
    const std::string key = std::string("crack_reach_") + name;
    keys[key + "_m"] = reach(share);
    keys[key + "_hole_radii"] = reach(share) / damage.hole_radius;
  }
  keys["crack_directions_beyond_30_radii"] = beyond(30.0);
  keys["crack_directions_beyond_50_radii"] = beyond(50.0);
  keys["crack_connected_share"] = cracks ? cracks->connected_share() : kNaN;
  keys["crack_note"] = nullptr;
  if (!cracks)
    keys["crack_note"] =
        "null: the run has not written which joints hold at its end (dump/joints.csv)";
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
  add_crack_keys(damage, keys);
  return keys;
}

Damage measured(const ResultFolder& folder, const DamageOptions& options) {
  const std::vector<FiredCharge> axes = axes_of(folder);
  const std::vector<StartBlock>& blocks = folder.rock();
  Snapshot last = read_snapshot(folder.snapshots().back(), folder.blocks());
  (void)split_muck(last.states, blocks.size());
  const double width =
      options.bin.value_or(mean_block_size(blocks, std::vector<char>(blocks.size(), 1)));
  Damage damage{{}, hole_radius(folder)};
  damage.cracks = cracks_of_run(folder, blocks, last.step, damage.hole_radius);
  damage.rings = damage_rings(damaged_blocks(blocks, last, axes, damage.cracks), width);
  damage.half = damage_radius(damage.rings, kHalf).value_or(kNaN);
  damage.tenth = damage_radius(damage.rings, kTenth).value_or(kNaN);
  return damage;
}

// cracks.csv and cracks.png, or neither.
void write_cracks(const ResultFolder& folder, const std::optional<CracksOfRun>& cracks) {
  for (const char* name : {"cracks.csv", "cracks.png"}) std::filesystem::remove(folder.file(name));
  if (!cracks) return;
  write_crack_table(*cracks, folder.file("cracks.csv"));
  write_png(draw_cracks(*cracks), folder.file("cracks.png"));
}

}  // namespace

void report_damage(const ResultFolder& folder, const DamageOptions& options) {
  try {
    const Damage damage = measured(folder, options);
    write_table(damage, folder.file("damage.csv"));
    write_png(draw_damage(damage), folder.file("damage.png"));
    write_cracks(folder, damage.cracks);
    nlohmann::ordered_json keys = common_keys(folder);
    keys.update(keys_of(damage));
    folder.merge_into_summary(keys, {refusal_key("damage")});
  } catch (const NotMeasurable& why) {
    write_cracks(folder, std::nullopt);
    take_back(folder, "damage", keys_of({}), why);
    throw;
  }
}

}  // namespace muckpile
