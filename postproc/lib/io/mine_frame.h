// SPDX-License-Identifier: GPL-2.0-or-later
// Where a run stands in the coordinates of its mine.
// Scope: what scene.json says; inputs that place their ground by files of the mine write it there.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/result_folder.h"
#include "math/types.h"

namespace muckpile {

// x, y and z of a run are 0 at `origin`, and x looks to `bearing`.
struct MineFrame {
  Vec3 origin = Vec3::Zero();  // east, north, height [m]
  double bearing = 0.0;        // from north over east [rad]

  [[nodiscard]] Vec3 of(const Vec3& local) const;  // east, north, height [m]
  [[nodiscard]] Vec3 back(const Vec3& mine) const;
};

// By the scene's keys terrain_east_m, terrain_north_m, terrain_height_m and x_bearing_deg. None
// where it lacks one of them, or where nothing was placed: origin 0 0 0 and no terrain file.
std::optional<MineFrame> mine_frame(const ResultFolder& folder);

// A table has two columns more where there is a frame: ",east_m,north_m" behind its header, and the
// place of a point (x, y) [m] behind the row.
std::string with_mine_columns(std::string header, const std::optional<MineFrame>& frame);
std::vector<double> mine_place(const std::optional<MineFrame>& frame, double x, double y);

// The same for points in space: east_m, north_m and elevation_m of each, behind its prefix.
std::string with_mine_points(std::string header, const std::optional<MineFrame>& frame,
                             const std::vector<std::string>& prefixes);
std::vector<double> mine_points(const std::optional<MineFrame>& frame,
                                const std::vector<Vec3>& points);

}  // namespace muckpile
