// SPDX-License-Identifier: GPL-2.0-or-later
// Whoever puts gas into the broken joints.
// Scope: an interface only; fix muckpile/gas implements it, fix muckpile/joint calls it.
#pragma once

#include "bond/network/facet_network.h"
#include "fixes/engine/block_halo.h"

namespace muckpile {

class JointPressure {
 public:
  virtual ~JointPressure() = default;
  /// Sets the network's gas pressures of all blocks in its present pose, just before its forces.
  virtual void fill_joints(FacetNetwork& network, engine::BlockHalo& halo) = 0;
  /// True while there is gas that may reach more joints.
  [[nodiscard]] virtual bool acts() const = 0;
};

}  // namespace muckpile
