// SPDX-License-Identifier: GPL-2.0-or-later
// Which spheres of which blocks are near each other: blocks first, then spheres of near blocks.
// Scope: one rank's spheres (its own ones first, copies of others behind); SI units.
#pragma once

#include <vector>

#include "contact/hierarchical_grid.h"
#include "math/types.h"

namespace muckpile {

/// A view of one rank's spheres; nothing is owned.
struct SphereSet {
  const double* positions;  ///< three per sphere [m]
  const double* radii;      ///< [m]
  const int* tags;          ///< unique number of the sphere, the same on all ranks
  const int* blocks;        ///< per sphere: block it belongs to, 0 .. blocks - 1, or -1: left out
  int count;                ///< all spheres
  int owned;                ///< the first `owned` belong to this rank
};

struct SpherePair {
  int first, second;  ///< indices of the spheres; the first has the lower tag
  int contact;        ///< free for the user, -1 when new
  double reach;       ///< sum of the radii [m]
};

struct BlockPair {
  int first, second;  ///< blocks
  int facet;          ///< free for the user, -1 when new
  int begin, end;     ///< its sphere pairs
};

/// Candidate list in three steps, so that the user can drop block pairs between the second and
/// the third. Deterministic; buffers are kept, no allocation once they have grown.
class BlockContactList {
 public:
  /// Sorts the spheres by block and bounds each block's present spheres. Blocks that have no
  /// sphere are allowed.
  void group(const SphereSet& spheres, int blocks);

  /// Pairs of blocks with bounding spheres less than `gap` [m] apart, at least one of them with an
  /// owned sphere. The caller may erase entries and set `facet`.
  std::vector<BlockPair>& find_block_pairs(double gap);

  /// Pairs of spheres less than `gap` [m] apart within the block pairs, at least one of the two
  /// owned; block pairs that have none are dropped. `spheres` as given to group().
  void find_sphere_pairs(const SphereSet& spheres, double gap);

  [[nodiscard]] const std::vector<BlockPair>& block_pairs() const { return block_pairs_; }
  [[nodiscard]] const std::vector<SpherePair>& sphere_pairs() const { return sphere_pairs_; }
  [[nodiscard]] std::vector<SpherePair>& sphere_pairs() { return sphere_pairs_; }
  /// Blocks left out of the last search because a position was not finite.
  [[nodiscard]] int skipped_blocks() const { return skipped_blocks_; }

 private:
  struct Member {
    Vec3 centre;    ///< [m]
    double radius;  ///< [m]
    int sphere;
  };

  void bound_block(int block);
  void members_near(int block, const BoundingSphere& other, double gap,
                    std::vector<Member>& out) const;

  std::vector<int> start_;       ///< per block: its first member; one more at the end
  std::vector<Member> members_;  ///< spheres sorted by block
  std::vector<BoundingSphere> bounds_;
  std::vector<int> item_block_;  ///< blocks that have spheres, as items of the grid
  std::vector<BoundingSphere> items_;
  std::vector<char> has_owned_;  ///< per block
  std::vector<BlockPair> block_pairs_;
  std::vector<SpherePair> sphere_pairs_;
  std::vector<Member> near_first_, near_second_;  ///< work space
  HierarchicalGrid grid_;
  int skipped_blocks_ = 0;
};

}  // namespace muckpile
