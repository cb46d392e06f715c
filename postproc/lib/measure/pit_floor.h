// SPDX-License-Identifier: GPL-2.0-or-later
// Heights of the pit floor in front of a bench.
// Scope: level at z = 0, or as it was surveyed; where the rock stands it is level at z = 0 behind
// the toe x = 0, and on the line from there to the surveyed floor in front of it.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "geometry/surface/surveyed_floor.h"
#include "measure/columns.h"

namespace muckpile {

class PitFloor {
 public:
  PitFloor() = default;  // level
  // A surveyed one by its triangles, which begins `front` in front of the toe [m]; others may be
  // there. Throws InputError, beginning with `where`, where none looks up.
  PitFloor(const std::vector<StlTriangle>& triangles, double front, const std::string& where);

  [[nodiscard]] bool level() const { return ground_ == nullptr; }
  [[nodiscard]] double at(double x, double y) const;
  // Of the cells of a grid.
  [[nodiscard]] std::vector<double> under(const ColumnGrid& grid) const;

 private:
  std::shared_ptr<const GroundHeights> ground_;
  double front_ = 0.0;  // [m]
};

}  // namespace muckpile
