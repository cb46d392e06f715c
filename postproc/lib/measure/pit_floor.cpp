// SPDX-License-Identifier: GPL-2.0-or-later
// Heights of the pit floor.
// Scope: see the header.
#include "measure/pit_floor.h"

#include "parallel/in_parallel.h"

namespace muckpile {

PitFloor::PitFloor(const std::vector<StlTriangle>& triangles, double front,
                   const std::string& where)
    : ground_(std::make_shared<const GroundHeights>(triangles, where)), front_(front) {}

double PitFloor::at(double x, double y) const {
  if (level()) return 0.0;
  if (x >= front_ || ground_->covers(x, y)) return ground_->at(x, y);
  return x <= 0.0 ? 0.0 : x / front_ * ground_->at(front_, y);
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
