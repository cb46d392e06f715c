// SPDX-License-Identifier: GPL-2.0-or-later
// Stress of single blocks, and how far a point is from a block.
// Scope: an interface only; fix muckpile/joint implements it, fix muckpile/gauges reads it.
#pragma once

#include <span>
#include <vector>

#include "math/types.h"

namespace muckpile {

class BlockStresses {
 public:
  virtual ~BlockStresses() = default;
  /// As bond/network/block_stress.h has it, of owned blocks by their body [Pa].
  [[nodiscard]] virtual std::vector<Mat3> stresses(std::span<const int> bodies) const = 0;
  /// Likewise, of every body of this rank [m].
  [[nodiscard]] virtual std::vector<double> distances_from_blocks(const Vec3& point) const = 0;
};

}  // namespace muckpile
