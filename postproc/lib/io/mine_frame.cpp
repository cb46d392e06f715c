// SPDX-License-Identifier: GPL-2.0-or-later
// Where a run stands in the coordinates of its mine.
// Scope: see the header.
#include "io/mine_frame.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace muckpile {

Vec3 MineFrame::of(const Vec3& local) const {
  const double s = std::sin(bearing), c = std::cos(bearing);
  return origin + Vec3(s * local.x() - c * local.y(), c * local.x() + s * local.y(), local.z());
}

Vec3 MineFrame::back(const Vec3& mine) const {
  const double s = std::sin(bearing), c = std::cos(bearing);
  const Vec3 d = mine - origin;
  return {s * d.x() + c * d.y(), -c * d.x() + s * d.y(), d.z()};
}

std::optional<MineFrame> mine_frame(const ResultFolder& folder) {
  const std::array<const char*, 4> keys{"terrain_east_m", "terrain_north_m", "terrain_height_m",
                                        "x_bearing_deg"};
  std::array<double, 4> values{};
  for (size_t k = 0; k < keys.size(); ++k) {
    if (!folder.scene_has(keys[k])) return std::nullopt;
    values[k] = folder.scene_number(keys[k]);
  }
  const MineFrame frame{{values[0], values[1], values[2]}, values[3] * std::numbers::pi / 180.0};
  const std::string terrain = folder.scene_word("terrain");
  if (frame.origin == Vec3::Zero() && (terrain.empty() || terrain == "none")) return std::nullopt;
  return frame;
}

std::string with_mine_columns(std::string header, const std::optional<MineFrame>& frame) {
  return frame ? std::move(header) + ",east_m,north_m" : header;
}

std::vector<double> mine_place(const std::optional<MineFrame>& frame, double x, double y) {
  if (!frame) return {};
  if (std::isnan(x) || std::isnan(y)) return {std::nan(""), std::nan("")};
  const Vec3 place = frame->of({x, y, 0.0});
  return {place.x(), place.y()};
}

std::string with_mine_points(std::string header, const std::optional<MineFrame>& frame,
                             const std::vector<std::string>& prefixes) {
  if (!frame) return header;
  for (const std::string& prefix : prefixes) {
    for (const char* column : {"east_m", "north_m", "elevation_m"})
      header.append(1, ',').append(prefix).append(column);
  }
  return header;
}

std::vector<double> mine_points(const std::optional<MineFrame>& frame,
                                const std::vector<Vec3>& points) {
  std::vector<double> places;
  if (!frame) return places;
  for (const Vec3& point : points) {
    const Vec3 place = frame->of(point);
    places.insert(places.end(), {place.x(), place.y(), place.z()});
  }
  return places;
}

}  // namespace muckpile
