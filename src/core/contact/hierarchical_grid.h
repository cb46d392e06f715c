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

/// Size-aware broad phase, after Ericson, Real-Time Collision Detection (2005), section 7.2, with
/// columns instead of cells.
///
/// A sphere lives in the column of its centre, on the level whose columns are one to two times as
/// wide as it is. Columns are sorted by height; those of the same level that lie beside each other,
/// and each with those of coarser levels that it reaches, are swept upwards together, so the cost
/// per sphere is a few columns per level, whatever the size range. Buffers are kept between calls:
/// no allocation once they have grown. The order of the result depends on the order of the items
/// only.
class HierarchicalGrid {
 public:
  /// All pairs whose surfaces are less than `gap` [m] apart, each once.
  /// Items with a negative radius, or a number that is not finite, are left out (see skipped()).
  /// The reference is valid until the next call.
  const std::vector<IndexPair>& find_pairs(std::span<const BoundingSphere> items, double gap);

  /// Appends to `found` the items of the last find_pairs() whose surfaces are less than its `gap`
  /// from that of `sphere`, which need not be one of them. All are as they were then.
  void find_partners(const BoundingSphere& sphere, std::vector<int>& found) const;

  /// Items left out of the last search.
  [[nodiscard]] int skipped() const { return skipped_; }

 private:
  struct Column {
    std::int64_t x, y;  ///< cell of its level
    int level;
    int begin, end;                       ///< of members_
    double low_x, high_x, low_y, high_y;  ///< of its members' centres [m]
  };
  struct Member {
    BoundingSphere sphere;
    int item;
  };
  struct Level {
    double inverse_width = 0.0;  ///< [1/m]
    double max_radius = 0.0;     ///< of the items that live here [m]
    int count = 0;
  };
  /// Cells of a level.
  struct Area {
    std::int64_t low_x, high_x, low_y, high_y;
  };

  void assign_levels(std::span<const BoundingSphere> items, double gap);
  void fill_columns(std::span<const BoundingSphere> items);
  [[nodiscard]] std::size_t slot_of(int level, std::int64_t x, std::int64_t y) const;
  [[nodiscard]] int column_of(int level, const Vec3& centre);
  [[nodiscard]] static Area area_about(const Column& column, double reach, double inverse_width);
  template <class Visit>
  void each_column(int level, const Area& area, const Visit& visit) const;
  void pair_up(const Column& column, int level);
  void sweep(const Column& a, const Column& b, double reach);
  void add_pair(const Member& a, const Member& b);

  std::vector<Level> levels_;
  std::vector<int> item_column_;  ///< per item, -1 if skipped
  std::vector<int> item_level_;   ///< the same of levels
  std::vector<Column> columns_;   ///< in the order of their first items
  std::vector<Member> members_;   ///< column by column, from low to high
  std::vector<int> slots_;        ///< hash table of columns
  std::vector<IndexPair> pairs_;
  double gap_ = 0.0;  ///< of the last search [m]
  int skipped_ = 0;
};

}  // namespace muckpile
