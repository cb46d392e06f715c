// SPDX-License-Identifier: GPL-2.0-or-later
// What gas in the joints of a facet network knows of it: its blocks and faces, which joints are
// broken and keep gas, and how far those have opened.
// Scope: reads a network that outlives it, as its last step left it; facets by their numbers there.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "bond/facet.h"
#include "bond/network/facet_network.h"

namespace muckpile {

class JointRooms {
 public:
  explicit JointRooms(const FacetNetwork& network) : network_(&network) {}

  /// Owned ones first, then copies of other ranks' blocks, the ground last.
  [[nodiscard]] std::span<const BlockConstants> blocks() const { return network_->blocks(); }
  [[nodiscard]] std::span<const BoundaryFace> faces() const { return network_->faces(); }

  [[nodiscard]] std::size_t facet_count() const { return network_->facet_count(); }
  [[nodiscard]] FacetEnds ends(std::size_t f) const { return network_->ends(f); }
  [[nodiscard]] std::span<const FacetState> states() const { return network_->states(); }
  /// Of a broken facet.
  [[nodiscard]] bool keeps_gas(std::size_t f) const { return network_->traces()[f].gas; }
  /// Whether the joint's law knows the apertures of facet f when it is broken.
  [[nodiscard]] bool law_has_apertures(std::size_t f) const {
    return network_->tables().joint(f).apertures(0.0).has_value();
  }
  /// Of each of `facets`, in order.
  void open(std::span<const LaneSet> facets, OpenJoints& joints) const {
    network_->open_joints(facets, joints);
  }

 private:
  const FacetNetwork* network_;
};

}  // namespace muckpile
