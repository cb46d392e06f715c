// SPDX-License-Identifier: GPL-2.0-or-later
// Pairs of nearby spheres of very different sizes: one hashed grid per size class.
// Scope: broad phase only; centres and radii in metres, any origin; works on one thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "math/types.h"

namespace muckpile {

struct BoundingSphere {
  Vec3 centre = Vec3::Zero();  ///< [m]
  double radius = 0.0;         ///< [m]
};

/// Whether the surfaces of two spheres are less than `gap` [m] apart; the same from both sides.
[[nodiscard]] inline bool within(const BoundingSphere& a, const BoundingSphere& b, double gap) {
  const double limit = a.radius + b.radius + gap;
  return (b.centre - a.centre).squaredNorm() < limit * limit;
}

struct IndexPair {
  int first, second;  ///< first < second
};

/// Size-aware broad phase, after Ericson, Real-Time Collision Detection (2005), section 7.2.
///
/// A sphere lives in the cell of its centre, on the level whose cells are one to two times as wide
/// as it is. It looks for partners on its own and on coarser levels only, so the cost per sphere is
/// a few cells per level, whatever the size range. Buffers are kept between calls: no allocation
/// once they have grown. The order of the result depends on the order of the items only.
class HierarchicalGrid {
 public:
  /// All pairs whose surfaces are less than `gap` [m] apart, each once.
  /// Items with a negative radius, or a number that is not finite, are left out (see skipped()).
  /// The reference is valid until the next call.
  const std::vector<IndexPair>& find_pairs(std::span<const BoundingSphere> items, double gap);

  /// Appends to `found` the items of the last find_pairs() whose surfaces are less than its `gap`
  /// from that of `sphere`, which need not be one of them. `items` are as they were then.
  void find_partners(std::span<const BoundingSphere> items, const BoundingSphere& sphere,
                     std::vector<int>& found) const;

  /// Items left out of the last search.
  [[nodiscard]] int skipped() const { return skipped_; }

 private:
  struct Cell {
    std::int64_t x, y, z;
    int first;  ///< head of the chain of items, kNone if the slot is empty
  };
  struct Level {
    double inverse_width;  ///< [1/m]
    double max_radius;     ///< of the items that live here [m]
    std::size_t slot_begin, slot_mask;
    int count;
  };

  void assign_levels(std::span<const BoundingSphere> items, double gap);
  void fill_cells(std::span<const BoundingSphere> items);
  [[nodiscard]] std::size_t slot_of(const Level& level, std::int64_t x, std::int64_t y,
                                    std::int64_t z) const;
  void query(std::span<const BoundingSphere> items, int item, int level);
  template <class Visit>
  void each_in_reach(const Level& level, const BoundingSphere& sphere, const Visit& visit) const;

  std::vector<Level> levels_;
  std::vector<int> level_of_;  ///< per item, kNone if skipped
  std::vector<int> next_;      ///< per item: next item in the same cell
  std::vector<Cell> cells_;    ///< the hash tables of all levels, one behind the other
  std::vector<IndexPair> pairs_;
  double gap_ = 0.0;  ///< of the last search [m]
  int skipped_ = 0;
};

}  // namespace muckpile
