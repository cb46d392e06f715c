// SPDX-License-Identifier: GPL-2.0-or-later
// The facet network of a rank, for reading.
// Scope: an interface only; fix muckpile/joint implements it, fix muckpile/gauges and fix
// muckpile/gas read it.
#pragma once

#include "bond/network/facet_network.h"

namespace muckpile {

class NetworkView {
 public:
  virtual ~NetworkView() = default;
  /// Blocks, joints and faces as the last force computation left them; blocks of this rank first,
  /// in the order of their bodies.
  [[nodiscard]] virtual const FacetNetwork& network() const = 0;
};

}  // namespace muckpile
