// SPDX-License-Identifier: GPL-2.0-or-later
// What a snapshot tells of the joints: which blocks hang together, and how far each is freed.
// Scope: an interface only; fix muckpile/joint implements it, fix muckpile/dump reads it.
#pragma once

#include <vector>

namespace muckpile {

class JointFragments {
 public:
  virtual ~JointFragments() = default;
  /// Per body of this rank, in body order: the smallest tag of its fragment, the blocks that hang
  /// together by joints of which a part still holds. Supports join nothing. Collective.
  [[nodiscard]] virtual std::vector<int> fragment_ids() const = 0;
  /// Per body of this rank, in body order: broken share of its joint area [-].
  [[nodiscard]] virtual std::vector<double> broken_share() const = 0;
};

}  // namespace muckpile
