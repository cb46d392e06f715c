// SPDX-License-Identifier: GPL-2.0-or-later
// Sub-command flyrock: what formulas of practice say of fly rock, and the farthest block of the
// run. Scope: formulas, no results; docs/post/flyrock.md says what each is made for.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "io/csv_writer.h"
#include "measure/blast_formulas.h"
#include "report/flyrock_holes.h"
#include "report/not_measurable.h"
#include "report/notes.h"
#include "report/reports.h"

namespace muckpile {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

struct Range {
  double low = kNaN, high = kNaN;  // for the two ends of the site constant [m]
  void widen(const Range& other) {
    low = std::fmax(low, other.low);
    high = std::fmax(high, other.high);
  }
};

// Each is the largest over the holes [m].
struct FlyrockRanges {
  Range face_burst, cratering, gun_barrelling;
  double depth_of_burial = kNaN;  // the least [m/kg^(1/3)]
  double mckenzie = kNaN;
  double fragment = kNaN;  // of McKenzie's range [m]
  bool open = false;       // a hole without stemming
};

struct Constants {
  explicit Constants(const FlyrockOptions& options)
      : low(options.site_constant.value_or(kRichardsMooreLow)),
        high(options.site_constant.value_or(kRichardsMooreHigh)),
        angle(options.launch_angle_deg * std::numbers::pi / 180.0) {}
  double low, high;
  double angle;  // of stemming [rad]
};

// A hole without stemming has no range by its formulas: it shoots into the open.
template <class Law>
Range range_of(const Constants& k, double confinement, Law&& law) {
  if (!(confinement > 0.0)) return {};
  return {law(k.low), law(k.high)};
}

FlyrockRanges ranges_of(const FlyrockHole& hole, const Constants& k, double rock_density) {
  FlyrockRanges r;
  r.face_burst = range_of(k, hole.burden, [&](double site) {
    return richards_moore_range(site, hole.mass_per_metre, hole.burden);
  });
  r.cratering = range_of(k, hole.stemming, [&](double site) {
    return richards_moore_range(site, hole.top_per_metre, hole.stemming);
  });
  r.gun_barrelling = range_of(k, hole.stemming, [&](double site) {
    return gun_barrelling_range(site, hole.top_per_metre, hole.stemming, k.angle);
  });
  r.depth_of_burial =
      scaled_depth_of_burial(hole.stemming, hole.top_length, hole.diameter, hole.top_per_metre);
  r.mckenzie = mckenzie_range(r.depth_of_burial, hole.diameter);
  r.fragment = mckenzie_fragment(r.depth_of_burial, hole.diameter, rock_density);
  r.open = !(hole.stemming > 0.0);
  return r;
}

FlyrockRanges largest_of(const std::vector<FlyrockRanges>& holes) {
  FlyrockRanges all;
  for (const FlyrockRanges& hole : holes) {
    all.face_burst.widen(hole.face_burst);
    all.cratering.widen(hole.cratering);
    all.gun_barrelling.widen(hole.gun_barrelling);
    all.open = all.open || hole.open;
    if (hole.mckenzie <= all.mckenzie) continue;
    all.mckenzie = hole.mckenzie;
    all.depth_of_burial = hole.depth_of_burial;
    all.fragment = hole.fragment;
  }
  return all;
}

void write_table(const std::filesystem::path& path, const std::vector<FlyrockHole>& holes,
                 const std::vector<FlyrockRanges>& ranges) {
  CsvWriter csv(path,
                "hole,row,diameter_m,burden_m,stemming_m,charge_kg_m,top_charge_kg_m,"
                "formula_face_burst_low_m,formula_face_burst_high_m,formula_cratering_low_m,"
                "formula_cratering_high_m,formula_gun_barrelling_low_m,"
                "formula_gun_barrelling_high_m,formula_depth_of_burial_m_kg033,formula_mckenzie_m,"
                "formula_mckenzie_fragment_m");
  for (size_t k = 0; k < holes.size(); ++k) {
    const FlyrockHole& h = holes[k];
    const FlyrockRanges& r = ranges[k];
    csv.row(h.name, {h.row + 1.0, h.diameter, h.burden, h.stemming, h.mass_per_metre,
                     h.top_per_metre, r.face_burst.low, r.face_burst.high, r.cratering.low,
                     r.cratering.high, r.gun_barrelling.low, r.gun_barrelling.high,
                     r.depth_of_burial, r.mckenzie, r.fragment});
  }
}

// Level way of the block that ended farthest from where it had been.
double farthest_block(const ResultFolder& folder) {
  const std::vector<StartBlock>& blocks = folder.blocks();
  const Snapshot last = read_snapshot(folder.snapshots().back(), blocks);
  double farthest = 0.0;
  for (size_t b = 0; b < blocks.size(); ++b) {
    const Vec3 way = last.states[b].centre - blocks[b].centroid;
    farthest = std::max(farthest, way.head<2>().norm());
  }
  return farthest;
}

nlohmann::ordered_json keys_of(const FlyrockRanges& r, const Constants& k, double safety_factor) {
  nlohmann::ordered_json keys;
  keys["formula_flyrock_k_low"] = k.low;
  keys["formula_flyrock_k_high"] = k.high;
  keys["formula_flyrock_safety_factor"] = safety_factor;
  for (const auto& [name, range] :
       {std::pair("face_burst", r.face_burst), std::pair("cratering", r.cratering),
        std::pair("gun_barrelling", r.gun_barrelling)}) {
    keys[std::string("formula_") + name + "_low_m"] = range.low;
    keys[std::string("formula_") + name + "_high_m"] = range.high;
  }
  keys["formula_depth_of_burial_m_kg033"] = r.depth_of_burial;
  keys["formula_mckenzie_m"] = r.mckenzie;
  keys["formula_mckenzie_fragment_m"] = r.fragment;
  const double largest = std::fmax(std::fmax(r.face_burst.high, r.cratering.high),
                                   std::fmax(r.gun_barrelling.high, r.mckenzie));
  keys["formula_clearance_m"] = r.open ? kNaN : safety_factor * largest;
  keys["formula_clearance_note"] = nullptr;
  if (r.open) keys["formula_clearance_note"] = kOpenHoleNote;
  keys["formula_flyrock_note"] = kFlyrockNote;
  keys["farthest_block_m"] = nullptr;
  keys["farthest_block_note"] = kLargestThrowNote;
  return keys;
}

}  // namespace

void report_flyrock(const ResultFolder& folder, const FlyrockOptions& options) {
  const Constants constants(options);
  try {
    constexpr const char* kDensity = "rock_density_kg_m3";
    const double density = folder.scene_has(kDensity) ? folder.scene_number(kDensity) : kNaN;
    const std::vector<FlyrockHole> holes = flyrock_holes(folder);
    std::vector<FlyrockRanges> ranges;
    for (const FlyrockHole& hole : holes) ranges.push_back(ranges_of(hole, constants, density));
    write_table(folder.file("flyrock.csv"), holes, ranges);
    nlohmann::ordered_json keys = common_keys(folder);
    keys.update(keys_of(largest_of(ranges), constants, options.safety_factor));
    keys["farthest_block_m"] = farthest_block(folder);
    folder.merge_into_summary(keys, {refusal_key("flyrock")});
  } catch (const NotMeasurable& why) {
    take_back(folder, "flyrock", keys_of({}, constants, options.safety_factor), why);
    throw;
  }
}

}  // namespace muckpile
