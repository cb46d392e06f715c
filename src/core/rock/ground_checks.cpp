// SPDX-License-Identifier: GPL-2.0-or-later
// Mouths of holes and the region's top beside surveyed ground.
// Scope: see the header.
#include "rock/ground_checks.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "args/first_lines.h"
#include "args/input_error.h"
#include "args/rounded_text.h"
#include "geometry/surface/mine_words.h"
#include "rock/cut_table.h"

namespace muckpile {
namespace {

const std::string kWarning = std::string("WARNING: ") + kCreateBlocks + ": ";

std::string name_of(const RockSurface& surface) {
  return (surface.kind == SurfaceIs::body ? "surface " : "terrain ") + surface.file;
}

std::string metres(double length) { return rounded_text(length, 3) + " m"; }

double distance_to(const Vec3& place, const RockSurface& surface) {
  return surface.index->closest(place).distance;
}

/// The surface that is nearest: the rock is what all share, and its top may be any of them.
const RockSurface& ground_at(const Vec3& place, const std::vector<RockSurface>& surfaces) {
  return *std::ranges::min_element(
      surfaces, {}, [&](const RockSurface& surface) { return distance_to(place, surface); });
}

/// "12.8 m below the terrain FILE, which is at z = 32.8 m there and 2.4 m from it at the nearest".
std::string place_of(const Collar& collar, const RockSurface& ground, double nearest) {
  std::vector<SurfaceIndex::Crossing> met;
  ground.index->crossings_at(collar.place.x(), collar.place.y(), met);
  if (met.empty()) return metres(nearest) + " from the " + name_of(ground);
  const double above = collar.place.z() - met.back().height;
  return metres(std::abs(above)) + (above > 0.0 ? " above" : " below") + " the " + name_of(ground) +
         ", which is at z = " + metres(met.back().height) + " there, and " + metres(nearest) +
         " from it by the nearest way";
}

std::string hole_text(const Collar& collar, const std::vector<RockSurface>& surfaces) {
  const RockSurface& ground = ground_at(collar.place, surfaces);
  const double nearest = distance_to(collar.place, ground);
  return "hole '" + collar.hole + "' of " + collar.file +
         " begins at z = " + metres(collar.place.z()) + ", " + place_of(collar, ground, nearest);
}

std::string advice() {
  return "; are holes and ground at one place, and both in metres (unit and origin; inputs/quarry: "
         "-var " +
         std::string(kUnitKnob) +
         ", terrain_east, terrain_north, terrain_height)? Where a hole goes through fill, let it "
         "begin on the rock";
}

/// The worst of those that are refused is told, the first ones that are warned of.
std::string check_collars(const CutOptions& options) {
  std::vector<std::string> warnings;
  const Collar* worst = nullptr;
  double farthest = kCollarElsewhere;
  for (const Collar& collar : options.collars) {
    const double nearest = distance_to(collar.place, ground_at(collar.place, options.surfaces));
    if (nearest > farthest) worst = &collar, farthest = nearest;
    if (nearest > kCollarOffGround)
      warnings.push_back(kWarning + hole_text(collar, options.surfaces) + '\n');
  }
  if (worst != nullptr)
    refuse(kCreateBlocks, hole_text(*worst, options.surfaces) + "; allowed are " +
                              metres(kCollarElsewhere) + advice());
  return first_lines(warnings, kWarning, "holes that begin so far from the ground");
}

std::string check_top(const RockSurface& surface, const Vec3& lo, const Vec3& hi) {
  constexpr int kColumns = 60;  // to each side
  std::vector<SurfaceIndex::Crossing> met;
  int above = 0;
  double highest = hi.z();
  for (int k = 0; k < kColumns * kColumns; ++k) {
    const double u = (k % kColumns + 0.5) / kColumns, v = (k / kColumns + 0.5) / kColumns;
    surface.index->crossings_at(lo.x() + u * (hi.x() - lo.x()), lo.y() + v * (hi.y() - lo.y()),
                                met);
    if (met.empty() || met.back().height <= hi.z()) continue;
    ++above;
    highest = std::max(highest, met.back().height);
  }
  const double share = above / static_cast<double>(kColumns * kColumns);
  if (share <= kCutOffShare) return "";
  return kWarning + name_of(surface) +
         " is higher than the region, which ends at z = " + metres(hi.z()) + ", over " +
         rounded_text(100.0 * share, 3) + " % of its plan, by up to " + metres(highest - hi.z()) +
         ": the rock ends level there; take a higher region (inputs/quarry: bench_height + "
         "burden), or put the ground where it is\n";
}

std::string check_places(const RockSurface& surface) {
  const DoubledPlaces& doubled = surface.doubled;
  if (doubled.places == 0) return "";
  return kWarning + name_of(surface) + " has two heights at " + std::to_string(doubled.places) +
         " place(s), " + metres(doubled.apart) + " apart at x = " + metres(doubled.lowest.x()) +
         ", y = " + metres(doubled.lowest.y()) +
         " of the run: one of them counts, and the ground leans from it to the next place. Give a "
         "steep face as triangles, or its toe and its crest at places that differ\n";
}

}  // namespace

std::string ground_checks(const CutOptions& options) {
  if (options.surfaces.empty()) return "";
  std::string warnings = check_collars(options);
  for (const RockSurface& surface : options.surfaces)
    warnings += check_places(surface) + check_top(surface, options.rock.lo, options.rock.hi);
  return warnings;
}

}  // namespace muckpile
