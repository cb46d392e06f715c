// SPDX-License-Identifier: GPL-2.0-or-later
// The time steps that pair_style muckpile/block gives as "steps_s" [s], in this order.
// Scope: places in an array, shared by the pair style and fix muckpile/timestep.
#pragma once

namespace muckpile {

enum ContactStep {
  kStableContacts,  ///< bound of the present contacts with their dashpots
  kStableSprings,   ///< the same without the dashpots
  kCollisions,      ///< resolves a light collision that may come; does not concern stability
  kContactSteps
};

}  // namespace muckpile
