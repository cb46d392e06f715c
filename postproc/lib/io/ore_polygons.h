// SPDX-License-Identifier: GPL-2.0-or-later
// Polygons in plan, as ore is staked out on a bench: a table of corners.
// Scope: bench coordinates; a polygon may be bounded in height, too.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "math/types.h"
#include "measure/scan_polygon.h"

namespace muckpile {

struct OrePolygon {
  std::string name;
  std::vector<Vec2> corners;  // (x, y) in order around it [m]
  double low, high;           // [m]; infinite where the table has no heights

  // Even-odd rule.
  [[nodiscard]] bool contains(const Vec2& point) const;
  [[nodiscard]] bool contains(const Vec3& point) const {
    return point.z() > low && point.z() < high && contains(Vec2(point.head<2>()));
  }
};

// Columns polygon, x_m, y_m and, both or neither, z_low_m and z_high_m; a row per corner, those of
// a polygon one after the other. Throws InputError, with file and line, on a polygon of fewer than
// three corners, without area, in two places, or with heights that differ or do not rise.
std::vector<OrePolygon> read_ore_polygons(const std::filesystem::path& path);

}  // namespace muckpile
