// SPDX-License-Identifier: GPL-2.0-or-later
// How the surface over a charge goes up and outward, ring by ring of where its rock started.
// Scope: surface z = 0, charge on the z axis; means by mass over the blocks that bound the surface.
#pragma once

#include <cstddef>
#include <vector>

#include "io/blocks_file.h"
#include "io/snapshot.h"

namespace muckpile {

// The blocks under the free surface whose centroids started within one ring about the axis.
struct SurfaceRing {
  double radius;  // mean distance of their centroids from the axis at the start [m]
  double mass;    // [kg]
  std::vector<std::size_t> blocks;
};

// Rings of this width [m] from the axis on; none for a ring without a block.
std::vector<SurfaceRing> surface_rings(const std::vector<StartBlock>& blocks, double width);

struct RingVelocity {
  double outward;  // away from the axis, in the direction in which each block started [m/s]
  double upward;   // [m/s]
};
RingVelocity velocity_of(const SurfaceRing& ring, const std::vector<StartBlock>& blocks,
                         const Snapshot& snapshot);

}  // namespace muckpile
