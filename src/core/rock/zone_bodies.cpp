// SPDX-License-Identifier: GPL-2.0-or-later
// Zones of rock inside of closed surfaces.
// Scope: see the header.
#include "rock/zone_bodies.h"

#include <algorithm>
#include <sstream>

#include "geometry/surface/mine_words.h"
#include "geometry/surface/surface_checks.h"
#include "rock/rock_surfaces.h"

namespace muckpile {
namespace {

std::string name_of(const RockZone& zone) {
  return "zone '" + zone.name + "': inside " + zone.body->file;
}

/// Of the region's rock, whatever zone it is of [m3].
double volume_within(const RockSurface& body, const CutOptions& options) {
  constexpr int kColumns = 200;
  std::vector<RockSurface> surfaces = options.surfaces;
  surfaces.push_back(body);
  const bool bounded = !options.surfaces.empty();
  return rock_volume(surfaces, bounded ? options.region_alone : options.rock.region,
                     options.rock.lo, options.rock.hi, kColumns);
}

double volume_of_blocks(std::size_t number, const RockModel& model) {
  double volume = 0.0;
  for (std::size_t b = 0; b < model.zone_of.size(); ++b)
    if (model.zone_of[b] == number) volume += model.rock.blocks[b].mass.volume;
  return volume;
}

}  // namespace

void read_zone_bodies(CutOptions& options) {
  for (RockZone& zone : options.zones) {
    if (!zone.body) continue;
    zone.body->index = read_body(zone.body->file, name_of(zone), options);
    zone.holds = [body = *zone.body](const Vec3& p) { return body.inside(p); };
  }
}

void check_zone_bodies(const CutOptions& options) {
  const Vec3 &lo = options.rock.lo, &hi = options.rock.hi;
  for (const RockZone& zone : options.zones) {
    if (!zone.body) continue;
    const std::string where = name_of(zone);
    const SurfaceIndex& index = *zone.body->index;
    if (!options.unit_given)
      require_likely_unit(index.lo(), index.hi(), false, lo, hi, where, "region", kUnitKnob);
    require_at_box(index.lo(), index.hi(), lo, hi, where, "it holds no rock of the region");
  }
}

std::string describe_zone_bodies(const CutOptions& options, const RockModel& model) {
  std::ostringstream text;
  text.precision(4);
  for (std::size_t z = 0; z < options.zones.size(); ++z) {
    const RockZone& zone = options.zones[z];
    if (!zone.body) continue;
    text << "  " << name_of(zone) << ": " << zone.body->index->triangles().size()
         << " triangles around " << volume_within(*zone.body, options)
         << " m3 of the region, its blocks have " << volume_of_blocks(z + 1, model) << " m3\n";
  }
  return text.str();
}

}  // namespace muckpile
