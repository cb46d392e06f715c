// SPDX-License-Identifier: GPL-2.0-or-later
// What has pushed each block so far, by cause.
// Scope: an interface only; fix muckpile/impulse implements it, fix muckpile/dump writes it.
#pragma once

#include <vector>

#include "motion/impulse_sums.h"

namespace muckpile {

class BlockImpulses {
 public:
  virtual ~BlockImpulses() = default;
  /// Of this rank; several ranks may have a row of one block, which add up to it.
  [[nodiscard]] virtual const std::vector<ImpulseRow>& impulses() const = 0;
};

}  // namespace muckpile
