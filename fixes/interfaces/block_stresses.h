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
  /// Mean Cauchy stress of each of `bodies` of this rank, each once, in their order, tension
  /// positive [Pa]; see bond/network/block_stress.h.
  [[nodiscard]] virtual std::vector<Mat3> stresses(std::span<const int> bodies) const = 0;
  /// Per body of this rank: how far `point` lies outside of its faces [m], negative within.
  [[nodiscard]] virtual std::vector<double> distances_from_blocks(const Vec3& point) const = 0;
};

}  // namespace muckpile
