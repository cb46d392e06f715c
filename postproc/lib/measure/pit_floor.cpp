// SPDX-License-Identifier: GPL-2.0-or-later
// Heights of the pit floor.
// Scope: see the header.
#include "measure/pit_floor.h"

#include "parallel/in_parallel.h"

namespace muckpile {

PitFloor::PitFloor(const std::vector<StlTriangle>& triangles, const std::string& where)
    : ground_(std::make_shared<const GroundHeights>(triangles, where)) {}

double PitFloor::at(double x, double y) const {
  if (level() || x <= 0.0) return 0.0;
  const double start = ground_->lo().x();
  return x < start ? x / start * ground_->at(start, y) : ground_->at(x, y);
}

std::vector<double> PitFloor::under(const ColumnGrid& grid) const {
  std::vector<double> heights(grid.cells(), 0.0);
  if (level()) return heights;
  const auto width = static_cast<size_t>(grid.nx);
  each_in_parallel(grid.cells(), [&](size_t k) {
    heights[k] = at(grid.x(static_cast<int>(k % width)), grid.y(static_cast<int>(k / width)));
  });
  return heights;
}

}  // namespace muckpile
