// SPDX-License-Identifier: GPL-2.0-or-later
// Block sizes of zones of rock.
// Scope: see the header.
#include "rock/zone_sizes.h"

#include <algorithm>
#include <limits>

#include "args/input_error.h"
#include "args/numbers.h"
#include "args/rounded_text.h"
#include "geometry/cut/ground.h"
#include "geometry/size/size_factor.h"
#include "rock/cut_table.h"
#include "rock/rock_surfaces.h"

namespace muckpile {
namespace {

std::string name_of(const RockZone& zone) {
  return std::string(kCreateBlocks) + ": zone '" + zone.name + "': size_factor";
}

const RockZone* first_with_factor(const std::vector<RockZone>& zones) {
  const auto found =
      std::ranges::find_if(zones, [](const RockZone& zone) { return zone.size_factor != 1.0; });
  return found == zones.end() ? nullptr : &*found;
}

/// Those of the law, wide enough for `size uniform` times the factors, too.
SizeLimits limits_of(const CutOptions& options) {
  double least = 1.0, most = 1.0;
  for (const RockZone& zone : options.zones) {
    least = std::min(least, zone.size_factor);
    most = std::max(most, zone.size_factor);
  }
  const SizeLimits &law = options.rock.size.limits(), &asked = options.limits;
  return {std::min(law.smallest, std::max(asked.smallest, least * law.smallest)),
          std::max(law.largest, std::min(asked.largest, most * law.largest))};
}

/// Sizes that the law has in each zone [m]; smallest above largest where there is no rock of it.
std::vector<SizeLimits> laws_in_zones(const CutOptions& options) {
  const Ground ground(options.rock);
  const double infinity = std::numeric_limits<double>::infinity();
  std::vector<SizeLimits> laws(options.zones.size() + 1, {infinity, 0.0});
  for (const Vec3& place : points_of_rock(options)) {
    SizeLimits& law = laws[zone_at(options.zones, place)];
    const double size = ground.size(place);
    law = {std::min(law.smallest, size), std::max(law.largest, size)};
  }
  return laws;
}

void refuse_without_effect(const CutOptions& options) {
  constexpr double kRounding = 1e-9;
  const std::vector<SizeLimits> laws = laws_in_zones(options);
  const SizeLimits limits = options.limits;
  for (std::size_t z = 0; z < options.zones.size(); ++z) {
    const RockZone& zone = options.zones[z];
    const SizeLimits law = laws[z + 1];
    const double factor = zone.size_factor;
    if (factor == 1.0 || law.smallest > law.largest) continue;
    const bool too_fine = factor < 1.0 && factor * law.largest < limits.smallest * (1 - kRounding);
    const bool too_coarse =
        factor > 1.0 && factor * law.smallest > limits.largest * (1 + kRounding);
    if (!too_fine && !too_coarse) continue;
    const std::string bound = too_fine ? "below block_min" : "above block_max";
    throw InputError(name_of(zone) + " must leave blocks between block_min and block_max, got '" +
                     number_text(factor) + "', with which all blocks of the zone (" +
                     rounded_text(factor * law.smallest) + " to " +
                     rounded_text(factor * law.largest) + " m) would be " + bound + " (" +
                     rounded_text(too_fine ? limits.smallest : limits.largest) + " m)");
  }
}

}  // namespace

void check_zone_sizes(const CutOptions& options) {
  const RockZone* zone = first_with_factor(options.zones);
  if (zone == nullptr) return;
  const char* rest = " needs a size law: not 'size ";
  if (options.import_file)
    throw InputError(name_of(*zone) + rest + "import', whose blocks have their size");
  if (options.target)
    throw InputError(name_of(*zone) + rest + "target', which is the curve of all of the rock");
}

void lay_zone_sizes(CutOptions& options) {
  if (first_with_factor(options.zones) == nullptr) return;
  refuse_without_effect(options);
  const auto wanted = [&](const Vec3& place) {
    const std::uint8_t zone = zone_at(options.zones, place);
    return zone == 0 ? 1.0 : options.zones[zone - 1u].size_factor;
  };
  options.rock.factor =
      std::make_shared<const SizeFactor>(options.rock, limits_of(options), wanted);
}

}  // namespace muckpile
