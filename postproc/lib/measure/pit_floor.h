// SPDX-License-Identifier: GPL-2.0-or-later
// Heights of the pit floor in front of a bench.
// Scope: level at z = 0, or as it was surveyed; behind the toe x = 0 it is level at z = 0.
#pragma once

#include <memory>
#include <vector>

#include "geometry/surface/surveyed_floor.h"
#include "measure/columns.h"

namespace muckpile {

class PitFloor {
 public:
  PitFloor() = default;  // level
  // A surveyed one by its triangles; others may be there. Throws InputError, beginning with
  // `where`, where none looks up.
  PitFloor(const std::vector<StlTriangle>& triangles, const std::string& where);

  [[nodiscard]] bool level() const { return ground_ == nullptr; }
  // [m]. Between the toe, at z = 0, and where a surveyed floor begins: on the line between.
  [[nodiscard]] double at(double x, double y) const;
  // Of the cells of a grid.
  [[nodiscard]] std::vector<double> under(const ColumnGrid& grid) const;

 private:
  std::shared_ptr<const GroundHeights> ground_;
};

}  // namespace muckpile
