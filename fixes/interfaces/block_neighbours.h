// SPDX-License-Identifier: GPL-2.0-or-later
// Which blocks are next to each other, as the contact style and the joints know it.
// Scope: interfaces only; fix muckpile/sleep asks what lies beside a block that moves.
#pragma once

#include <span>

namespace muckpile {

/// By spheres: blocks near enough to touch soon.
class NearBlocks {
 public:
  virtual ~NearBlocks() = default;
  /// `from` and `to`: one entry per sphere, owned ones and ghosts. Marks with 1 in `to` a sphere of
  /// every block that is near a block whose spheres are marked in `from`.
  virtual void mark_near(std::span<const char> from, std::span<char> to) const = 0;
};

/// By joints: blocks that share a facet which still acts.
class JoinedBlocks {
 public:
  virtual ~JoinedBlocks() = default;
  /// `moves`: one entry per body of this rank, 1 if it moves; sets `disturbed` of every body that
  /// shares a facet with one that moves, on whatever rank, or that lies on ground which yields.
  /// Collective.
  virtual void mark_joined(std::span<const char> moves, std::span<char> disturbed) = 0;
  /// Facets between bodies that all rest are left alone. One entry per body. Collective.
  virtual void let_rest(std::span<const char> rests) = 0;
  virtual void wake_all() = 0;
};

}  // namespace muckpile
