// SPDX-License-Identifier: GPL-2.0-or-later
// The forces of joints, holes and gas on each block, apart from each other.
// Scope: an interface only; fix muckpile/joint implements it, fix muckpile/impulse reads it.
#pragma once

#include <span>

#include "motion/impulse_sums.h"

namespace muckpile {

class ForceParts {
 public:
  virtual ~ForceParts() = default;
  /// What the last force computation put on each body of this rank, in body order [N]: the parts
  /// wave, hole_gas, joint_gas and joints are written.
  virtual void forces_by_part(std::span<ByPart> forces) = 0;
};

}  // namespace muckpile
