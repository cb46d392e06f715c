// SPDX-License-Identifier: GPL-2.0-or-later
// Broken share of the joints against the distance from the charges.
// Scope: see the header.
#include "measure/damage.h"

#include <cmath>
#include <map>

namespace muckpile {

std::vector<DamageRing> damage_rings(const std::vector<DamagedBlock>& blocks, double width) {
  std::map<long, DamageRing> rings;  // fractions are sums of volumes at first
  for (const DamagedBlock& block : blocks) {
    const long number = static_cast<long>(std::floor(block.distance / width));
    const double middle = (static_cast<double>(number) + 0.5) * width;
    DamageRing& ring = rings.try_emplace(number, DamageRing{middle, 0, 0.0, 0.0}).first->second;
    ++ring.blocks;
    ring.volume += block.volume;
    ring.broken_fraction += block.volume * block.broken_fraction;
    ring.connected_fraction += block.volume * block.connected_fraction;
  }
  std::vector<DamageRing> list;
  for (auto& [number, ring] : rings) {
    ring.broken_fraction /= ring.volume;
    ring.connected_fraction /= ring.volume;
    list.push_back(ring);
  }
  return list;
}

std::optional<double> damage_radius(const std::vector<DamageRing>& rings, double level) {
  for (size_t k = rings.size(); k-- > 0;) {
    if (rings[k].broken_fraction < level) continue;
    if (k + 1 == rings.size()) return std::nullopt;
    const DamageRing &inner = rings[k], &outer = rings[k + 1];
    const double share =
        (inner.broken_fraction - level) / (inner.broken_fraction - outer.broken_fraction);
    return inner.distance + share * (outer.distance - inner.distance);
  }
  return std::nullopt;
}

}  // namespace muckpile
