// SPDX-License-Identifier: GPL-2.0-or-later
// Broken share of the joints against the distance from the charges, and where it ends.
// Scope: rings of equal width; a block counts in the ring of its centroid, with its volume.
#pragma once

#include <optional>
#include <vector>

namespace muckpile {

struct DamagedBlock {
  double distance;                  // from the nearest charge's axis, at the start [m]
  double volume;                    // [m3]
  double broken_fraction;           // of its joint area
  double connected_fraction = 0.0;  // of it in cracks that hang together with a hole
};

struct DamageRing {
  double distance;  // of its middle [m]
  int blocks;
  double volume;                    // of its blocks [m3]
  double broken_fraction;           // mean by volume
  double connected_fraction = 0.0;  // the same
};

// From the nearest ring to the farthest, without empty ones. `width` > 0 [m].
std::vector<DamageRing> damage_rings(const std::vector<DamagedBlock>& blocks, double width);

// Where the share falls below `level` for good, linear between rings [m]. Nothing where no ring has
// as much, or the last one still has.
std::optional<double> damage_radius(const std::vector<DamageRing>& rings, double level);

}  // namespace muckpile
