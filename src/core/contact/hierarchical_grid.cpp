// SPDX-License-Identifier: GPL-2.0-or-later
// Hashed grids by size class: filling and search.
// Scope: see the header. Open addressing, tables at most half full.
#include "contact/hierarchical_grid.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

namespace muckpile {

namespace {

constexpr int kNone = -1;
constexpr int kMaxLevels = 64;
// Beyond this many cells from the origin all cells are one: safe to convert, still correct because
// the distance decides.
constexpr double kFarthestCell = 1e15;

bool is_usable(const BoundingSphere& s) {
  return s.centre.allFinite() && s.radius >= 0.0 && std::isfinite(4.0 * s.radius);
}

std::int64_t cell_index(double coordinate, double inverse_width) {
  return static_cast<std::int64_t>(
      std::clamp(std::floor(coordinate * inverse_width), -kFarthestCell, kFarthestCell));
}

}  // namespace

void HierarchicalGrid::assign_levels(std::span<const BoundingSphere> items, double gap) {
  double smallest = std::numeric_limits<double>::max(), largest = 0.0;
  for (const BoundingSphere& s : items) {
    if (!is_usable(s)) continue;
    smallest = std::min(smallest, 2.0 * s.radius + gap);
    largest = std::max(largest, 2.0 * s.radius + gap);
  }
  if (largest <= 0.0) largest = 1.0;  // points without a gap: any width does
  const double base =
      std::max(smallest, std::ldexp(largest, 1 - kMaxLevels));  // width of the finest cells [m]

  levels_.assign(kMaxLevels + 1, Level{0.0, 0.0, 0, 0, 0});
  level_of_.assign(items.size(), kNone);
  skipped_ = 0;
  for (std::size_t k = 0; k < items.size(); ++k) {
    if (!is_usable(items[k])) {
      ++skipped_;
      continue;
    }
    const double ratio = (2.0 * items[k].radius + gap) / base;
    const int level = ratio <= 1.0 ? 0 : std::min(kMaxLevels, std::ilogb(ratio) + 1);
    level_of_[k] = level;
    Level& l = levels_[static_cast<std::size_t>(level)];
    ++l.count;
    l.max_radius = std::max(l.max_radius, items[k].radius);
    l.inverse_width = 1.0 / std::ldexp(base, level);
  }
}

std::size_t HierarchicalGrid::slot_of(const Level& level, std::int64_t x, std::int64_t y,
                                      std::int64_t z) const {
  std::uint64_t h = static_cast<std::uint64_t>(x) * 0x9E3779B97F4A7C15ULL;
  h = (h ^ static_cast<std::uint64_t>(y)) * 0xC2B2AE3D27D4EB4FULL;
  h = (h ^ static_cast<std::uint64_t>(z)) * 0x165667B19E3779F9ULL;
  h ^= h >> 32;
  std::size_t slot = static_cast<std::size_t>(h) & level.slot_mask;
  for (;;) {
    const Cell& c = cells_[level.slot_begin + slot];
    if (c.first == kNone || (c.x == x && c.y == y && c.z == z)) return level.slot_begin + slot;
    slot = (slot + 1) & level.slot_mask;
  }
}

void HierarchicalGrid::fill_cells(std::span<const BoundingSphere> items) {
  std::size_t slots = 0;
  for (Level& level : levels_) {
    if (level.count == 0) continue;
    const std::size_t size = std::bit_ceil(2 * static_cast<std::size_t>(level.count));
    level.slot_begin = slots;
    level.slot_mask = size - 1;
    slots += size;
  }
  cells_.assign(slots, Cell{0, 0, 0, kNone});
  next_.assign(items.size(), kNone);
  for (std::size_t k = items.size(); k-- > 0;) {  // backwards: chains then run in rising order
    if (level_of_[k] == kNone) continue;
    const Level& level = levels_[static_cast<std::size_t>(level_of_[k])];
    const Vec3& c = items[k].centre;
    const std::int64_t x = cell_index(c.x(), level.inverse_width);
    const std::int64_t y = cell_index(c.y(), level.inverse_width);
    const std::int64_t z = cell_index(c.z(), level.inverse_width);
    Cell& cell = cells_[slot_of(level, x, y, z)];
    next_[k] = cell.first;
    cell = Cell{x, y, z, static_cast<int>(k)};
  }
}

/// Items of a level in the cells that may hold a partner of `sphere`.
template <class Visit>
void HierarchicalGrid::each_in_reach(const Level& level, const BoundingSphere& sphere,
                                     const Visit& visit) const {
  const double reach = sphere.radius + level.max_radius + gap_;  // [m]
  std::int64_t low[3], high[3];
  for (int d = 0; d < 3; ++d) {
    low[d] = cell_index(sphere.centre[d] - reach, level.inverse_width);
    high[d] = cell_index(sphere.centre[d] + reach, level.inverse_width);
  }
  for (std::int64_t x = low[0]; x <= high[0]; ++x)
    for (std::int64_t y = low[1]; y <= high[1]; ++y)
      for (std::int64_t z = low[2]; z <= high[2]; ++z)
        for (int other = cells_[slot_of(level, x, y, z)].first; other != kNone;
             other = next_[static_cast<std::size_t>(other)])
          visit(other);
}

void HierarchicalGrid::query(std::span<const BoundingSphere> items, int item, int level_number) {
  const BoundingSphere& me = items[static_cast<std::size_t>(item)];
  const bool own_level = level_of_[static_cast<std::size_t>(item)] == level_number;
  each_in_reach(levels_[static_cast<std::size_t>(level_number)], me, [&](int other) {
    if (own_level && other <= item) return;  // counted by the other one
    if (within(me, items[static_cast<std::size_t>(other)], gap_))
      pairs_.push_back(IndexPair{std::min(item, other), std::max(item, other)});
  });
}

const std::vector<IndexPair>& HierarchicalGrid::find_pairs(std::span<const BoundingSphere> items,
                                                           double gap) {
  pairs_.clear();
  gap_ = gap;
  assign_levels(items, gap);
  fill_cells(items);
  for (std::size_t k = 0; k < items.size(); ++k) {
    if (level_of_[k] == kNone) continue;
    for (int level = level_of_[k]; level <= kMaxLevels; ++level)
      if (levels_[static_cast<std::size_t>(level)].count > 0)
        query(items, static_cast<int>(k), level);
  }
  return pairs_;
}

void HierarchicalGrid::find_partners(std::span<const BoundingSphere> items,
                                     const BoundingSphere& sphere, std::vector<int>& found) const {
  const auto visit = [&](int other) {
    if (within(sphere, items[static_cast<std::size_t>(other)], gap_)) found.push_back(other);
  };
  for (std::size_t number = 0; number < levels_.size(); ++number) {
    const Level& level = levels_[number];
    if (level.count == 0) continue;
    const double across =
        2.0 * (sphere.radius + level.max_radius + gap_) * level.inverse_width + 1.0;
    if (across * across * across < static_cast<double>(items.size())) {
      each_in_reach(level, sphere, visit);
      continue;
    }
    for (std::size_t k = 0; k < items.size(); ++k)  // a large sphere among many small cells
      if (level_of_[k] == static_cast<int>(number)) visit(static_cast<int>(k));
  }
}

}  // namespace muckpile
