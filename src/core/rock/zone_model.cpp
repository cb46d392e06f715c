// SPDX-License-Identifier: GPL-2.0-or-later
// Zones of rock by a block model.
// Scope: see the header.
#include "rock/zone_model.h"

#include <algorithm>
#include <utility>

#include "args/input_error.h"
#include "geometry/surface/surface_checks.h"
#include "rock/cut_table.h"
#include "rock/gauge_points.h"
#include "rock/rock_surfaces.h"

namespace muckpile {
namespace {

std::string name_of(const CutOptions& options) { return "block_model " + options.model.file; }

template <class Visit>
void for_corners(const Vec3& lo, const Vec3& hi, const Visit& visit) {
  for (int k = 0; k < 8; ++k)
    visit(Vec3((k & 1) != 0 ? hi.x() : lo.x(), (k & 2) != 0 ? hi.y() : lo.y(),
               (k & 4) != 0 ? hi.z() : lo.z()));
}

/// A box around a box in another frame.
template <class Map>
Eigen::AlignedBox3d mapped(const Vec3& lo, const Vec3& hi, const Map& map) {
  Eigen::AlignedBox3d box;
  for_corners(lo, hi, [&](const Vec3& corner) { box.extend(map(corner)); });
  return box;
}

void require_at_region(const CutOptions& options) {
  Eigen::AlignedBox3d all;
  for (const RockCell& cell : options.model.cells) all.extend(cell.lo()).extend(cell.hi());
  const auto here =
      mapped(all.min(), all.max(), [&](const Vec3& p) { return options.mine.to_run(p); });
  require_at_box(here.min(), here.max(), options.rock.lo, options.rock.hi,
                 std::string(kCreateBlocks) + ": " + name_of(options),
                 "none of its cells holds rock of the region");
}

/// Those that reach into the box around the region: models of mines are much larger than a blast.
std::vector<RockCell> cells_at_region(const CutOptions& options) {
  const auto box = mapped(options.rock.lo, options.rock.hi,
                          [&](const Vec3& p) { return options.mine.to_mine(p); });
  std::vector<RockCell> here;
  for (const RockCell& cell : options.model.cells)
    if (box.intersects(Eigen::AlignedBox3d(cell.lo(), cell.hi()))) here.push_back(cell);
  return here;
}

/// What of the rock no zone and no cell holds.
struct Bare {
  std::size_t count = 0, all = 0;
  Vec3 first = Vec3::Zero();
  void look(const CutOptions& options, const Vec3& place) {
    ++all;
    if (zone_at(options.zones, place) > 0 ||
        options.model.index->zone_at(options.mine.to_mine(place)))
      return;
    if (count++ == 0) first = place;
  }
};

void refuse_bare(const CutOptions& options, const Bare& bare, const std::string& what) {
  if (bare.count == 0) return;
  refuse(kCreateBlocks,
         name_of(options) + " must cover the rock, leaves " + std::to_string(bare.count) + " of " +
             std::to_string(bare.all) + ' ' + what + " in no cell and no zone, as at " +
             place_text(bare.first) + " m, which is " +
             place_text(options.mine.to_mine(bare.first)) +
             " m of the file; add cells there, or say 'block_model FILE partial' for rock of the "
             "keyword density where there are none");
}

}  // namespace

void read_zone_model(CutOptions& options, const ArgValues& args) {
  RockNames names;
  for (const RockZone& zone : options.zones) {
    names.zones.push_back(zone.name);
    names.of_model.push_back(zone.of_model);
  }
  const auto first = std::ranges::find(options.zones, true, &RockZone::of_model);
  const auto& groups = args.groups("block_model");
  if (groups.empty() && first == options.zones.end()) return;
  if (groups.empty())
    refuse(kCreateBlocks, "zone '" + first->name + "': model needs block_model FILE");
  const std::vector<std::string>& words = groups.front();
  options.model.file = words[0];
  options.model.partial = words.size() > 1;
  if (options.model.partial && words[1] != "partial")
    refuse(kCreateBlocks, name_of(options) + " may end with 'partial', got '" + words[1] + "'");
  if (first == options.zones.end())
    refuse(kCreateBlocks, name_of(options) + " needs a 'zone NAME DENSITY model' for its rock");
  options.model.cells = read_rock_cells(words[0], names, options.unit);
}

void lay_zone_model(CutOptions& options) {
  if (options.model.file.empty()) return;
  require_at_region(options);
  options.model.cells = cells_at_region(options);
  options.model.index = std::make_shared<const RockCells>(options.model.cells, name_of(options));
  for (std::size_t z = 0; z < options.zones.size(); ++z) {
    if (!options.zones[z].of_model) continue;
    options.zones[z].holds = [index = options.model.index, mine = options.mine, zone = z + 1](
                                 const Vec3& p) { return index->zone_at(mine.to_mine(p)) == zone; };
  }
  if (options.model.partial) return;
  Bare bare;
  for (const Vec3& place : points_of_rock(options)) bare.look(options, place);
  refuse_bare(options, bare, "points of a grid");
}

void require_cells(const CutOptions& options, const RockModel& model) {
  if (options.model.file.empty() || options.model.partial) return;
  Bare bare;
  for (const Block& block : model.rock.blocks) bare.look(options, block.mass.centroid);
  refuse_bare(options, bare, "blocks");
}

std::string describe_zone_model(const CutOptions& options) {
  if (options.model.file.empty()) return "";
  return "  " + name_of(options) + ": " + std::to_string(options.model.index->size()) +
         " cells reach into the region's box\n";
}

}  // namespace muckpile
