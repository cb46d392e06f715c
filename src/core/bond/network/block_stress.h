// SPDX-License-Identifier: GPL-2.0-or-later
// Mean stress of single blocks of a facet network, and how far a point is from a block.
// Scope: reads a network as its last step left it; a few blocks at a time, no part of a step. SI
// units.
#pragma once

#include <span>
#include <vector>

#include "bond/network/facet_network.h"

namespace muckpile {

/// Cauchy stress of each of `blocks` [Pa], tension positive: the symmetric part of the sum of
/// A t (x) r over facets and loaded faces, over the volume; r from the block's centre to where the
/// traction t acts. Joints, contact of broken ones without its dashpots, what softening points
/// still hold, gas in joints and pressure on the crushed zone's wall; no contact of spheres. Why
/// that is the mean of the body's stress: docs/styles/fix_muckpile_gauges.md. `blocks`: indices of
/// owned blocks, each once.
[[nodiscard]] std::vector<Mat3> block_stresses(const FacetNetwork& network,
                                               std::span<const int> blocks);

/// Per owned block: how far `point` lies outside of its faces as they are now [m], negative within.
/// Outside beyond an edge it is the distance of the farthest plane, a lower bound.
[[nodiscard]] std::vector<double> distances_from_blocks(const FacetNetwork& network,
                                                        const Vec3& point);

}  // namespace muckpile
