// SPDX-License-Identifier: GPL-2.0-or-later
// Hashed columns by size class: filling and search.
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

  levels_.assign(kMaxLevels + 1, Level{});
  item_level_.assign(items.size(), kNone);
  skipped_ = 0;
  for (std::size_t k = 0; k < items.size(); ++k) {
    if (!is_usable(items[k])) {
      ++skipped_;
      continue;
    }
    const double ratio = (2.0 * items[k].radius + gap) / base;
    const int level = ratio <= 1.0 ? 0 : std::min(kMaxLevels, std::ilogb(ratio) + 1);
    item_level_[k] = level;
    Level& l = levels_[static_cast<std::size_t>(level)];
    ++l.count;
    l.max_radius = std::max(l.max_radius, items[k].radius);
    l.inverse_width = 1.0 / std::ldexp(base, level);
  }
}

std::size_t HierarchicalGrid::slot_of(int level, std::int64_t x, std::int64_t y) const {
  std::uint64_t h = static_cast<std::uint64_t>(x) * 0x9E3779B97F4A7C15ULL;
  h = (h ^ static_cast<std::uint64_t>(y)) * 0xC2B2AE3D27D4EB4FULL;
  h = (h ^ static_cast<std::uint64_t>(level)) * 0x165667B19E3779F9ULL;
  h ^= h >> 32;
  const std::size_t mask = slots_.size() - 1;
  for (std::size_t slot = static_cast<std::size_t>(h) & mask;; slot = (slot + 1) & mask) {
    if (slots_[slot] == kNone) return slot;
    const Column& c = columns_[static_cast<std::size_t>(slots_[slot])];
    if (c.x == x && c.y == y && c.level == level) return slot;
  }
}

int HierarchicalGrid::column_of(int level, const Vec3& centre) {
  const double inverse_width = levels_[static_cast<std::size_t>(level)].inverse_width;
  const std::int64_t x = cell_index(centre.x(), inverse_width);
  const std::int64_t y = cell_index(centre.y(), inverse_width);
  const std::size_t slot = slot_of(level, x, y);
  if (slots_[slot] == kNone) {
    slots_[slot] = static_cast<int>(columns_.size());
    columns_.push_back({x, y, level, 0, 0, centre.x(), centre.x(), centre.y(), centre.y()});
  }
  return slots_[slot];
}

void HierarchicalGrid::fill_columns(std::span<const BoundingSphere> items) {
  slots_.assign(std::bit_ceil(2 * items.size() + 1), kNone);
  columns_.clear();
  item_column_.assign(items.size(), kNone);
  for (std::size_t k = 0; k < items.size(); ++k) {
    if (item_level_[k] == kNone) continue;
    const Vec3& centre = items[k].centre;
    item_column_[k] = column_of(item_level_[k], centre);
    Column& column = columns_[static_cast<std::size_t>(item_column_[k])];
    ++column.end;
    column.low_x = std::min(column.low_x, centre.x());
    column.high_x = std::max(column.high_x, centre.x());
    column.low_y = std::min(column.low_y, centre.y());
    column.high_y = std::max(column.high_y, centre.y());
  }
  int begin = 0;
  for (Column& column : columns_) {
    column.begin = begin;
    begin += column.end;
    column.end = column.begin;
  }
  members_.resize(static_cast<std::size_t>(begin));
  for (std::size_t k = 0; k < items.size(); ++k) {
    if (item_level_[k] == kNone) continue;
    Column& column = columns_[static_cast<std::size_t>(item_column_[k])];
    members_[static_cast<std::size_t>(column.end++)] = {items[k], static_cast<int>(k)};
  }
  for (const Column& column : columns_)
    std::sort(members_.begin() + column.begin, members_.begin() + column.end,
              [](const Member& a, const Member& b) {
                const double z_a = a.sphere.centre.z(), z_b = b.sphere.centre.z();
                return z_a < z_b || (z_a == z_b && a.item < b.item);
              });
}

/// Cells within `reach` [m] of a rectangle, a little more for rounding.
HierarchicalGrid::Area HierarchicalGrid::area_about(const Column& column, double reach,
                                                    double inverse_width) {
  const double wide = 1.000000001 * reach;
  return {cell_index(column.low_x - wide, inverse_width),
          cell_index(column.high_x + wide, inverse_width),
          cell_index(column.low_y - wide, inverse_width),
          cell_index(column.high_y + wide, inverse_width)};
}

/// The columns of a level in an area, which may be larger than all of them.
template <class Visit>
void HierarchicalGrid::each_column(int level, const Area& area, const Visit& visit) const {
  const double cells = (static_cast<double>(area.high_x - area.low_x) + 1.0) *
                       (static_cast<double>(area.high_y - area.low_y) + 1.0);
  if (cells > static_cast<double>(columns_.size())) {
    for (const Column& c : columns_)
      if (c.level == level && area.low_x <= c.x && c.x <= area.high_x && area.low_y <= c.y &&
          c.y <= area.high_y)
        visit(c);
    return;
  }
  for (std::int64_t x = area.low_x; x <= area.high_x; ++x)
    for (std::int64_t y = area.low_y; y <= area.high_y; ++y)
      if (const int found = slots_[slot_of(level, x, y)]; found != kNone)
        visit(columns_[static_cast<std::size_t>(found)]);
}

void HierarchicalGrid::add_pair(const Member& a, const Member& b) {
  if (within(a.sphere, b.sphere, gap_))
    pairs_.push_back({std::min(a.item, b.item), std::max(a.item, b.item)});
}

/// Of two columns, or of one with itself. `reach`: no pair of theirs lies further apart.
void HierarchicalGrid::sweep(const Column& a, const Column& b, double reach) {
  int from = b.begin;
  for (int i = a.begin; i < a.end; ++i) {
    const Member& me = members_[static_cast<std::size_t>(i)];
    const auto above = [&](int j) {
      return members_[static_cast<std::size_t>(j)].sphere.centre.z() - me.sphere.centre.z();
    };
    if (&a == &b)
      from = i + 1;
    else
      while (from < b.end && above(from) < -reach) ++from;
    for (int j = from; j < b.end && above(j) <= reach; ++j)
      add_pair(me, members_[static_cast<std::size_t>(j)]);
  }
}

/// With columns of its own level, each two of them once, or with those of a coarser one.
void HierarchicalGrid::pair_up(const Column& column, int level) {
  const Level& other = levels_[static_cast<std::size_t>(level)];
  const double reach =
      levels_[static_cast<std::size_t>(column.level)].max_radius + other.max_radius + gap_;
  each_column(level, area_about(column, reach, other.inverse_width), [&](const Column& c) {
    if (level == column.level && std::pair(c.x, c.y) < std::pair(column.x, column.y)) return;
    sweep(column, c, reach);
  });
}

const std::vector<IndexPair>& HierarchicalGrid::find_pairs(std::span<const BoundingSphere> items,
                                                           double gap) {
  pairs_.clear();
  gap_ = gap;
  assign_levels(items, gap);
  fill_columns(items);
  for (const Column& column : columns_)
    for (int level = column.level; level <= kMaxLevels; ++level)
      if (levels_[static_cast<std::size_t>(level)].count > 0) pair_up(column, level);
  return pairs_;
}

void HierarchicalGrid::find_partners(const BoundingSphere& sphere, std::vector<int>& found) const {
  const Vec3& centre = sphere.centre;
  const Column at{0, 0, 0, 0, 0, centre.x(), centre.x(), centre.y(), centre.y()};
  for (int number = 0; number < static_cast<int>(levels_.size()); ++number) {
    const Level& level = levels_[static_cast<std::size_t>(number)];
    if (level.count == 0) continue;
    const double reach = sphere.radius + level.max_radius + gap_;
    const auto visit = [&](const Column& c) {
      const auto begin = members_.begin() + c.begin, end = members_.begin() + c.end;
      auto m = std::partition_point(begin, end, [&](const Member& member) {
        return member.sphere.centre.z() - centre.z() < -reach;
      });
      for (; m != end && m->sphere.centre.z() - centre.z() <= reach; ++m)
        if (within(sphere, m->sphere, gap_)) found.push_back(m->item);
    };
    each_column(number, area_about(at, reach, level.inverse_width), visit);
  }
}

}  // namespace muckpile
