// SPDX-License-Identifier: GPL-2.0-or-later
// The time steps that pair_style muckpile/block gives as "steps_s" [s], in this order.
// Scope: places in an array, shared by the pair style and fix muckpile/timestep.
#pragma once

namespace muckpile {

/// A block is joined while a facet that may act holds it, to another block or to the ground.
enum ContactStep {
  kFreeContacts,    ///< bound of the present contacts of blocks without joints, with their dashpots
  kFreeSprings,     ///< the same without the dashpots
  kJoinedContacts,  ///< bound of those of joined blocks, with their dashpots
  kJoinedSprings,   ///< the same without the dashpots
  kCollisions,      ///< resolves a light collision that may come; does not concern stability
  kContactSteps
};

}  // namespace muckpile
