// SPDX-License-Identifier: GPL-2.0-or-later
// Cells of a block model, as mine planning programs export them: boxes of rock of one name.
// Scope: boxes along the axes of the file, of any sizes; places in the file's coordinates [m].
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "geometry/index/box_tree.h"

namespace muckpile {

struct RockCell {
  Vec3 middle = Vec3::Zero();  ///< [m]
  Vec3 size = Vec3::Zero();    ///< edges [m]
  std::uint8_t zone = 0;       ///< 0: the rock beside the zones; k: the zone of number k
  std::size_t row = 0;         ///< of the file's table
  [[nodiscard]] Vec3 lo() const { return middle - 0.5 * size; }
  [[nodiscard]] Vec3 hi() const { return middle + 0.5 * size; }
};

/// The words that a cell may have in the columns `rock` and `zone`.
struct RockNames {
  std::vector<std::string> zones;  ///< all, in their order
  std::vector<bool> of_model;      ///< whether cells may be of it
};

/// Of a CSV file with the columns x, y, z (middle of a cell), dx, dy, dz (its edges), and either
/// `rock` (a name) or `zone` (a number); any order, other columns are left alone. `unit` is what
/// lengths count in [m]. Throws InputError, with file and line.
[[nodiscard]] std::vector<RockCell> read_rock_cells(const std::string& file, const RockNames& names,
                                                    double unit);

class RockCells {
 public:
  /// Throws InputError, with `where` before it, for two cells that hold one place.
  RockCells(std::vector<RockCell> cells, const std::string& where);

  [[nodiscard]] std::size_t size() const { return cells_.size(); }
  /// Of the cell that holds a place, or that misses it by rounding (kCellRounding).
  [[nodiscard]] std::optional<std::uint8_t> zone_at(const Vec3& place) const;

 private:
  void refuse_overlaps(const std::string& where) const;

  std::vector<RockCell> cells_;
  BoxTree tree_;
};

/// Part of a cell's least edge by which rounded cells may overlap, or miss each other.
inline constexpr double kCellRounding = 1e-3;

}  // namespace muckpile
