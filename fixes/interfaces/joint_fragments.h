// SPDX-License-Identifier: GPL-2.0-or-later
// What snapshots tell of the joints: which blocks hang together, how far each is freed, and which
// joints still hold.
// Scope: an interface only; fix muckpile/joint implements it, fix muckpile/dump reads it.
#pragma once

#include <vector>

namespace muckpile {

/// A joint between two blocks, named by the block of the smaller tag and its face.
struct HoldingJoint {
  int tag;
  int face;             ///< number in the polyhedron of that block
  double broken_share;  ///< below 1 [-]
};

class JointFragments {
 public:
  virtual ~JointFragments() = default;
  /// Per body of this rank, in body order: the smallest tag of its fragment, the blocks that hang
  /// together by joints of which a part still holds. Supports join nothing. Collective.
  [[nodiscard]] virtual std::vector<int> fragment_ids() const = 0;
  /// Per body of this rank, in body order: broken share of its joint area [-].
  [[nodiscard]] virtual std::vector<double> broken_share() const = 0;
  /// Joints of which a part holds, those that a body of this rank names.
  [[nodiscard]] virtual std::vector<HoldingJoint> holding_joints() const = 0;
};

}  // namespace muckpile
