// SPDX-License-Identifier: GPL-2.0-or-later
// Which spheres of which blocks are near each other: blocks first, then spheres of near blocks,
// looked up again only when two blocks have moved against each other by enough.
// Scope: one rank's spheres (its own ones first, copies of others behind); SI units. Blocks are
// rigid: their spheres keep their distances.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <unordered_set>
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
  /// Each sphere is drawn about a body of another shape: its surface moves as the body turns.
  bool around_bodies = false;
};

struct SpherePair {
  int first, second;  ///< indices of the spheres; the first has the lower tag
  int contact;        ///< free for the user, -1 when new
  double reach;       ///< sum of the radii [m]
};

/// Two blocks, and the sphere pairs of theirs that are near each other since the last look_up().
struct BlockPair {
  double due = 0.0;            ///< path of both blocks before which moved() is false [m]
  int facet = -1;              ///< free for the user
  int begin = 0, count = 0;    ///< its sphere pairs
  int room = 0;                ///< sphere pairs that fit in its place
  int first = 0, second = 0;   ///< blocks
  double slack = -1.0;         ///< no other spheres touch before that much motion [m]; < 0: unknown
  double travel = 0.0;         ///< of both blocks' turning, at the last look [m]
  Vec3 offset = Vec3::Zero();  ///< second block's reference less the first's, at the last look [m]
};

/// Candidate list. Deterministic; buffers are kept, no allocation once they have grown.
/// Use: group(), find_block_pairs(); then per step follow() once, wake() each block pair, work on
/// the candidates() of those that may touch, and let those rest() of which none does. Once a block
/// is outgrown(): add_block_pairs(), or group() and find_block_pairs().
class BlockContactList {
 public:
  /// Sorts the spheres by block and bounds each block's present spheres. Blocks that have no
  /// sphere are allowed.
  void group(const SphereSet& spheres, int blocks);

  /// Pairs of blocks that can touch before one of them is outgrown(), at least one of them with an
  /// owned sphere. The caller may erase entries and set `facet`. Every block may move by `range`
  /// [m].
  std::vector<BlockPair>& find_block_pairs(double range);
  /// The fastest block may move by `range`, slower ones by less, in proportion to their speed, but
  /// for kLeastShare of it. `velocities` [m/s], `spins` of each sphere's block [rad/s]: three per
  /// sphere.
  std::vector<BlockPair>& find_block_pairs(double range, const double* velocities,
                                           const double* spins);
  /// True if a block has moved further than its pairs allow for.
  [[nodiscard]] bool outgrown() const { return !outgrown_.empty(); }
  /// Gives blocks that are outgrown() a range about their present place, and appends the pairs that
  /// they can now be in; the others stay as they are. False, and nothing done, if so many blocks
  /// have been outgrown since find_block_pairs() that all are better looked for anew.
  [[nodiscard]] bool add_block_pairs(const SphereSet& spheres, const double* velocities,
                                     const double* spins);

  /// Takes over where the blocks are after a step. `spins`: angular velocity of each sphere's
  /// block, three per sphere [rad/s].
  void follow(const double* positions, const double* spins, double time_step);

  /// True if the blocks have moved against each other so far that spheres may be near which are
  /// not listed. Exact up to the difference between a turn and the path of its angle.
  [[nodiscard]] bool moved(BlockPair& pair) const {
    const double path = path_of(pair.first, pair.second);
    if (path < pair.due) return false;
    const Place& a = places_[static_cast<std::size_t>(pair.first)];
    const Place& b = places_[static_cast<std::size_t>(pair.second)];
    const double left = pair.slack - (a.travel + b.travel - pair.travel) -
                        (b.reference - a.reference - pair.offset).norm();
    pair.due = path + left;
    return left < 0.0;
  }
  /// Whether spheres of block pair k may touch in this step; looks them up first if they moved().
  /// Of a pair that cannot touch yet only the paths of its blocks are read.
  [[nodiscard]] bool wake(std::size_t k, const SphereSet& spheres, std::vector<int>& dropped) {
    if (k >= gates_.size()) make_gates();
    const Gate& gate = gates_[k];
    if (path_of(gate.first, gate.second) >= gate.due) open(k, spheres, dropped);
    return gate.count > 0;
  }
  /// Of a pair that wake() has let through, until the next look_up() or wake() of any.
  [[nodiscard]] std::span<SpherePair> candidates(std::size_t k) {
    return std::span(sphere_pairs_)
        .subspan(static_cast<std::size_t>(gates_[k].begin),
                 static_cast<std::size_t>(gates_[k].count));
  }
  /// None of the candidates of block pair k touches: wake() holds it back until one can, by how far
  /// its blocks have gone, and then by how far they have moved against each other.
  void rest(std::size_t k, const double* positions);
  /// Nothing of block pair k is nearer to touching than this [m], above 0.
  void rest(std::size_t k, double gap);
  /// Leaves block pair k alone until it is activated again.
  void deactivate(std::size_t k);
  void activate(std::size_t k);
  [[nodiscard]] bool inactive(std::size_t k) const {
    return k < gates_.size() && gates_[k].due == std::numeric_limits<double>::infinity();
  }

  /// Lists the pair's spheres (at least one of the two owned) that are less than the margin apart:
  /// kMargin times the bounding radius of the smaller block. Spheres listed before keep their
  /// `contact`; that of spheres no longer listed is appended to `dropped`.
  void look_up(BlockPair& pair, const SphereSet& spheres, std::vector<int>& dropped);

  [[nodiscard]] std::vector<BlockPair>& block_pairs() { return block_pairs_; }
  [[nodiscard]] const std::vector<BlockPair>& block_pairs() const { return block_pairs_; }
  [[nodiscard]] SpherePair* sphere_pairs(const BlockPair& pair) {
    return sphere_pairs_.data() + pair.begin;
  }
  /// Blocks left out of the last search because a position was not finite.
  [[nodiscard]] int skipped_blocks() const { return skipped_blocks_; }
  [[nodiscard]] double bytes() const;

  /// A wider margin means more candidates per step, a narrower one more looks.
  static constexpr double kMargin = 0.1;
  /// A larger share means more block pairs, a smaller one more searches.
  static constexpr double kLeastShare = 0.1;
  /// Of the blocks, that pairs are added for between two searches for all.
  static constexpr double kMostAdded = 0.25;

 private:
  /// What wake() needs of a block pair.
  struct Gate {
    double due = -1.0;         ///< path of both blocks from which on the pair must be looked at [m]
    int first, second;         ///< blocks
    int begin = 0, count = 0;  ///< sphere pairs to be worked on before
  };

  /// What was between the two blocks of a pair when nothing of it touched.
  struct Clearance {
    double gap = 0.0;            ///< [m]; not above 0: unknown
    double travel = 0.0;         ///< of both blocks' turning, then [m]
    Vec3 offset = Vec3::Zero();  ///< second block's reference less the first's, then [m]
  };

  [[nodiscard]] double path_of(int first, int second) const {
    return path_[static_cast<std::size_t>(first)] + path_[static_cast<std::size_t>(second)];
  }
  void make_gates();
  /// By how much the blocks may still move against each other before anything of pair k touches
  /// that did not when it was laid to rest [m].
  [[nodiscard]] double clearance_left(std::size_t k) const;
  void open(std::size_t k, const SphereSet& spheres, std::vector<int>& dropped);

  struct Member {
    double radius;  ///< [m]
    int sphere;
  };
  /// A sphere that may touch another block.
  struct Facing {
    Vec3 centre;    ///< [m]
    double radius;  ///< [m]
    int sphere;
  };
  struct Place {
    Vec3 reference;       ///< centre of the block's reference sphere [m]
    double travel = 0.0;  ///< path of its farthest sphere about the reference, by turning [m]
    Vec3 start;           ///< reference when the range was given [m]
    double range = std::numeric_limits<double>::infinity();  ///< that a sphere may move from there
    double travel_then = 0.0;                                ///< travel when the range was given
  };
  /// A block that has a new range.
  struct Added {
    BoundingSphere swept;  ///< what it may reach from there
    int block;
  };

  [[nodiscard]] BoundingSphere bound_of(const SphereSet& spheres, std::size_t block) const;
  void place_block(const SphereSet& spheres, std::size_t block, const BoundingSphere& bound);
  [[nodiscard]] double speed_of(std::size_t block, const double* velocities,
                                const double* spins) const;
  [[nodiscard]] double range_of(std::size_t block, const double* velocities,
                                const double* spins) const;
  void pair_up();
  void list_pair(int first, int second);
  void give_range(const SphereSet& spheres, int block, double range);
  void add_partners(int block);
  void take_all(int block, const SphereSet& spheres, std::vector<Facing>& kept) const;
  void drop_averted(int other, double margin, double& slack, std::vector<Facing>& kept) const;
  void list_near(const BlockPair& pair, const SphereSet& spheres, double margin, double& slack);
  void keep_contacts(BlockPair& pair, std::vector<int>& dropped);

  std::vector<int> start_;       ///< per block: its first member; one more at the end
  std::vector<Member> members_;  ///< spheres sorted by block
  std::vector<int> reference_;   ///< per block: the sphere that stands for its position
  std::vector<double> arm_;      ///< per block: farthest sphere centre from the reference [m]
  std::vector<double> extent_;   ///< per block: farthest point from the reference [m]
  std::vector<Place> places_;    ///< per block
  std::vector<int> item_block_;  ///< blocks that have spheres, as items of the grid
  std::vector<int> block_item_;  ///< per block: its item, or that of another
  std::vector<BoundingSphere> items_;
  std::vector<BoundingSphere> swept_;  ///< what they may reach, as in the last search for all
  std::vector<Added> added_;           ///< blocks that have another range by now
  std::vector<int> added_at_;          ///< per block: its place in added_, -1: none
  std::unordered_set<std::uint64_t> added_pairs_;  ///< by their two blocks
  std::vector<int> partners_;                      ///< work space of add_partners
  std::vector<char> has_owned_;                    ///< per block
  std::vector<BlockPair> block_pairs_;
  std::vector<SpherePair> sphere_pairs_;
  std::vector<SpherePair> near_;                      ///< work space of look_up
  std::vector<Facing> facing_first_, facing_second_;  ///< work space of list_near
  HierarchicalGrid grid_;
  int skipped_blocks_ = 0;
  std::vector<Gate> gates_;                  ///< per block pair; those behind have none yet
  std::vector<Clearance> clearances_;        ///< per gate
  std::vector<double> path_;                 ///< per block: no point of it went further [m]
  std::vector<int> outgrown_;                ///< blocks
  double most_range_ = 0.0, fastest_ = 0.0;  ///< of the last search for all [m], [m/s]
};

}  // namespace muckpile
