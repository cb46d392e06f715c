// SPDX-License-Identifier: GPL-2.0-or-later
// A free face of any shape.
// Scope: see the header.
#include "measure/face_map.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace muckpile {
namespace {

int cell_of(double place, double first, double step, int count) {
  return static_cast<int>(
      std::clamp(std::floor((place - first) / step), 0.0, static_cast<double>(count - 1)));
}

// Rows without rock become as the nearest row that has some.
void fill_rows(const ColumnGrid& grid, const std::vector<int>& met, std::vector<double>& x) {
  for (int j = 0; j < grid.ny; ++j) {
    if (met[static_cast<size_t>(j)] > 0) continue;
    int nearest = -1;
    for (int other = 0; other < grid.ny; ++other) {
      const bool nearer = nearest < 0 || std::abs(other - j) < std::abs(nearest - j);
      if (met[static_cast<size_t>(other)] > 0 && nearer) nearest = other;
    }
    for (int i = 0; i < grid.nx; ++i) x[grid.at(i, j)] = x[grid.at(i, nearest)];
  }
}

}  // namespace

FaceMap::FaceMap(const Columns& lines, size_t blocks)
    : grid_(lines.grid),
      x_(lines.top),
      met_(static_cast<size_t>(lines.grid.ny), 0),
      at_face_(blocks, 0) {
  std::vector<double> known;
  for (int j = 0; j < grid_.ny; ++j) {
    std::optional<double> below;
    for (int i = 0; i < grid_.nx; ++i) {
      double& here = x_[grid_.at(i, j)];
      if (here == kNoRock) {
        if (below) here = *below;
        continue;
      }
      if (!below)  // nothing from the floor up to here
        for (int under = 0; under < i; ++under) x_[grid_.at(under, j)] = here;
      below = here;
      known.push_back(here);
      met_[static_cast<size_t>(j)] = i + 1;
      at_face_[static_cast<size_t>(lines.top_block[grid_.at(i, j)])] = 1;
    }
  }
  fill_rows(grid_, met_, x_);
  const auto middle = known.begin() + static_cast<std::ptrdiff_t>(known.size() / 2);
  std::ranges::nth_element(known, middle);
  middle_ = *middle;
}

int FaceMap::column(double z) const { return cell_of(z, grid_.x0, grid_.dx, grid_.nx); }

int FaceMap::row(double y) const { return cell_of(-y, grid_.y0, grid_.dy, grid_.ny); }

std::vector<Vec2> FaceMap::section(double y) const {
  const int j = row(y);
  std::vector<Vec2> points;
  for (int i = 0; i < met_[static_cast<size_t>(j)]; ++i)
    points.emplace_back(x_[grid_.at(i, j)], grid_.x(i));
  return points;
}

}  // namespace muckpile
