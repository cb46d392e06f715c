// SPDX-License-Identifier: GPL-2.0-or-later
// Block sizes of zones of rock.
// Scope: see the header.
#include "rock/zone_sizes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

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

std::string describe_zone_sizes(const CutOptions& options, const Tessellation& cut,
                                const std::vector<std::uint8_t>& zone_of) {
  constexpr double kHalf = 0.5;  // of the way from the law's size to that of the factor
  if (first_with_factor(options.zones) == nullptr) return "";
  TessellationOptions plain = options.rock;
  plain.factor = nullptr;
  const Ground ground(plain);
  // Size over that of the law, of the block of each zone that comes nearest to the factor.
  std::vector<std::optional<double>> nearest(options.zones.size() + 1);
  for (std::size_t b = 0; b < zone_of.size(); ++b) {
    if (zone_of[b] == 0) continue;
    const double factor = options.zones[zone_of[b] - 1u].size_factor;
    const double ratio = cut.blocks[b].target_size / ground.size(cut.blocks[b].mass.centroid);
    std::optional<double>& best = nearest[zone_of[b]];
    if (!best || std::abs(ratio - factor) < std::abs(*best - factor)) best = ratio;
  }
  std::string text;
  for (std::size_t z = 1; z < nearest.size(); ++z) {
    const RockZone& zone = options.zones[z - 1];
    if (zone.size_factor == 1.0 || !nearest[z]) continue;
    if ((*nearest[z] - 1.0) / (zone.size_factor - 1.0) >= kHalf) continue;
    text +=
        "WARNING: " + name_of(zone) + " " + number_text(zone.size_factor) + " leaves all blocks " +
        rounded_text(*nearest[z], 3) +
        " times as large as the law or nearer to it: the zone is thin against the blocks, or near "
        "holes, where the law holds, or block_min and block_max bound it\n";
  }
  return text;
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
