// SPDX-License-Identifier: GPL-2.0-or-later
// Surfaces of the rock from files.
// Scope: see the header.
#include "rock/rock_surfaces.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <sstream>

#include "args/input_error.h"
#include "args/numbers.h"
#include "geometry/surface/mine_words.h"
#include "geometry/surface/surface_checks.h"
#include "rock/cut_table.h"

namespace muckpile {
namespace {

std::string name_of(const RockSurface& surface) {
  return (surface.kind == SurfaceIs::body ? "surface " : "terrain ") + surface.file;
}

[[noreturn]] void refuse_words(const std::string& text) { refuse(kCreateBlocks, text); }

RockSurface read_terrain(const std::string& file, const CutOptions& options) {
  RockSurface surface{file, SurfaceIs::terrain, nullptr};
  const SurveyedSurface survey = read_placed(file, options);
  surface.doubled = doubled_places(survey.points, kDoubledPlace * options.limits.smallest);
  std::vector<StlTriangle> triangles = terrain_triangles(survey);
  if (triangles.empty())
    refuse(name_of(surface), "must have points that do not lie on one line in plan");
  surface.index = std::make_shared<const SurfaceIndex>(std::move(triangles));
  return surface;
}

void require_rock(const CutOptions& options) {
  if (!points_of_rock(options).empty()) return;
  refuse_words(
      "region and surfaces share no rock: is the region where the surfaces leave rock, and "
      "is the ground below the terrain in it?");
}

}  // namespace

SurveyedSurface read_placed(const std::string& file, const CutOptions& options) {
  return read_placed(file, options.mine, options.unit);
}

void read_mine_frame(CutOptions& options, const ArgValues& args) {
  // An input with a knob for the terrain says `terrain none`, and gives the rest all the same.
  const bool none = args.given("surface") || args.given("terrain");
  options.mine_files = args.word("surface") != "none" || args.word("terrain") != "none" ||
                       args.given("block_model") || args.given("fault") ||
                       std::ranges::any_of(args.groups("zone"), names_a_file);
  for (const char* word : {"origin", "x_bearing", "unit"})
    if (args.given(word) && !options.mine_files && !none)
      refuse_words(std::string(word) +
                   " needs a file in mine coordinates, such as surface or terrain");
  const MineWords words = read_mine_words(args, kCreateBlocks);
  options.mine = words.frame;
  options.unit = words.unit;
  options.unit_given = words.unit_given;
}

std::shared_ptr<const SurfaceIndex> read_body(const std::string& file, const std::string& where,
                                              const CutOptions& options) {
  std::vector<StlTriangle> triangles = read_placed(file, options).triangles;
  if (triangles.empty())
    refuse(where, "must be triangles, as .stl or .dxf has, got points; give those as terrain");
  require_closed(triangles, where);
  auto index = std::make_shared<const SurfaceIndex>(std::move(triangles));
  require_outward(*index, where);
  return index;
}

std::vector<Vec3> points_of_rock(const CutOptions& options) {
  constexpr int kPoints = 24;  // per axis
  const Vec3& lo = options.rock.lo;
  const Vec3 step = (options.rock.hi - lo) / kPoints;
  std::vector<Vec3> points;
  for (int k = 0; k < kPoints * kPoints * kPoints; ++k) {
    const Vec3 at(k % kPoints + 0.5, k / kPoints % kPoints + 0.5, k / (kPoints * kPoints) + 0.5);
    const Vec3 place = lo + at.cwiseProduct(step);
    if (!options.rock.region.inside || options.rock.region.inside(place)) points.push_back(place);
  }
  return points;
}

void read_surfaces(CutOptions& options, const ArgValues& args) {
  const std::string &body = args.word("surface"), &terrain = args.word("terrain");
  if (body == "none" && terrain == "none") return;
  if (options.import_file)
    refuse_words("size import leaves nothing to cut: no surface and no terrain");
  if (body != "none") {
    RockSurface surface{body, SurfaceIs::body, nullptr};
    surface.index = read_body(body, name_of(surface), options);
    options.surfaces.push_back(std::move(surface));
  }
  if (terrain != "none") options.surfaces.push_back(read_terrain(terrain, options));
}

void lay_surfaces(CutOptions& options) {
  if (options.surfaces.empty()) return;
  const Vec3 lo = options.rock.lo, hi = options.rock.hi;
  for (const RockSurface& surface : options.surfaces) {
    const bool body = surface.kind == SurfaceIs::body;
    const std::string where = std::string(kCreateBlocks) + ": " + name_of(surface);
    const SurfaceIndex& index = *surface.index;
    if (!options.unit_given)
      require_likely_unit(index.lo(), index.hi(), body, lo, hi, where, "region", kUnitKnob);
    // Ground above all of the region cuts nothing off, ground below leaves nothing.
    const bool above = !body && index.lo().z() > hi.z();
    require_at_box(index.lo(), index.hi(), lo, hi, where,
                   above ? "it cuts nothing off" : "no rock is left");
    if (!body) require_height_field(index, lo, hi, where);
  }
  options.region_alone = options.rock.region;
  options.rock.region = within(options.region_alone, options.surfaces);
  require_rock(options);
}

SurfaceOutcome surface_outcome(const CutOptions& options, const Tessellation& cut) {
  constexpr int kColumns = 300;
  const Vec3 &lo = options.rock.lo, &hi = options.rock.hi;
  SurfaceOutcome outcome{surface_fit(cut.blocks, options.surfaces, lo, hi), 0.0, 0.0};
  outcome.rock = rock_volume(options.surfaces, options.region_alone, lo, hi, kColumns);
  const std::vector<double>& voids = cut.statistics.hole_volume;
  outcome.cut = std::accumulate(voids.begin(), voids.end(), cut.statistics.block_volume);
  return outcome;
}

std::string describe_mine_frame(const CutOptions& options) {
  if (!options.mine_files) return "";
  const Vec3& o = options.mine.origin;
  return "  place 0 0 0 is " + number_text(o.x()) + ' ' + number_text(o.y()) + ' ' +
         number_text(o.z()) + " m of the files in mine coordinates; x looks to the bearing " +
         number_text(options.mine.bearing * 180.0 / M_PI) + " degrees\n";
}

std::string describe_surfaces(const CutOptions& options, const Tessellation& cut) {
  if (options.surfaces.empty()) return "";
  const SurfaceOutcome outcome = surface_outcome(options, cut);
  std::ostringstream text;
  for (const RockSurface& surface : options.surfaces)
    text << "  " << name_of(surface) << ": " << surface.index->triangles().size() << " triangles\n";
  text.precision(4);
  text << "  rock within region and surfaces " << outcome.rock << " m3, blocks and crushed zones "
       << outcome.cut << " m3 (" << std::showpos << 100.0 * (outcome.cut / outcome.rock - 1.0)
       << std::noshowpos << " %); faces on the surfaces lie off them by "
       << outcome.fit.mean_distance << " blocks in the mean, " << outcome.fit.largest_distance
       << " at most, " << 100.0 * outcome.fit.within_a_quarter
       << " % of their area within a quarter\n";
  return text.str();
}

}  // namespace muckpile
