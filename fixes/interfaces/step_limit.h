// SPDX-License-Identifier: GPL-2.0-or-later
// What the choice of a time step needs of the joints.
// Scope: an interface only; fix muckpile/joint implements it, fix muckpile/timestep reads it.
#pragma once

#include "bond/linear/stable_step.h"

namespace muckpile {

class StepLimit {
 public:
  virtual ~StepLimit() = default;
  /// Longest step that the joints bear about the pose of the last force computation, all ranks
  /// together. `guess` [s]: an earlier result, saves work; 0: none. Collective.
  [[nodiscard]] virtual StepBound stable_step(Breaking breaking, double guess) const = 0;
  /// How often commands have changed their stiffness or dashpots so far.
  [[nodiscard]] virtual int stiffness_changes() const = 0;
};

}  // namespace muckpile
