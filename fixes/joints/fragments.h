// SPDX-License-Identifier: GPL-2.0-or-later
// Fragments: connected components of blocks over joints of which a part still holds.
// Scope: supports (fixed, mirror) join nothing; works across ranks without gathering.
#pragma once

#include <mpi.h>

#include <vector>

#include "bond/network/facet_network.h"
#include "fixes/engine/block_halo.h"
#include "fixes/interfaces/joint_fragments.h"

namespace muckpile {

/// Per owned block, in body order: the smallest tag of its fragment. Collective.
[[nodiscard]] std::vector<int> fragment_ids(const FacetNetwork& network,
                                            const engine::BlockHalo& halo, MPI_Comm world);

/// Per owned block, in body order: broken share of its joint area [-].
[[nodiscard]] std::vector<double> broken_share(const FacetNetwork& network, std::size_t owned);

/// Joints between two blocks of which a part holds, those whose first block is owned.
[[nodiscard]] std::vector<HoldingJoint> holding_joints(const FacetNetwork& network,
                                                       std::size_t owned);

}  // namespace muckpile
