// SPDX-License-Identifier: GPL-2.0-or-later
// What the contact style needs to know of the joints: which block pairs a facet still joins.
// Scope: an interface only; fix muckpile/joint implements it, pair muckpile/block reads it.
#pragma once

#include <span>
#include <vector>

#include "bond/network/facet_memory.h"

namespace muckpile {

class JointView {
 public:
  virtual ~JointView() = default;
  /// Index of the facet shared by two blocks given by body tag, -1 if none.
  /// Valid until the next reneighbouring.
  [[nodiscard]] virtual int facet_between(int block_tag_a, int block_tag_b) const = 0;
  /// States of all facets known to this rank, indexed as above; re-read the pointer every step.
  [[nodiscard]] virtual const FacetState* facet_states() const = 0;
  /// Adds the two tags of every facet that is whole or cracked and joins one of `blocks` (in rising
  /// order) to another block, of those that this rank knows.
  virtual void joined_pairs(const std::vector<int>& blocks, std::vector<double>& tags) const = 0;
  /// True for a block whose facets are all intact and none of which lies on a free face or a
  /// crushed zone: nothing outside can touch it.
  [[nodiscard]] virtual bool enclosed(int block_tag) const = 0;
  /// Marks with 1 every body of this rank that a facet joins to another one or to the ground, or
  /// may hold again: one that is not retired.
  virtual void mark_joined_bodies(std::span<char> joined) const = 0;
};

}  // namespace muckpile
