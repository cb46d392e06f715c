// SPDX-License-Identifier: GPL-2.0-or-later
// A free face of any shape: where the rock begins, seen along -x, by height and place along the
// bench.
// Scope: rock above the pit floor z = 0; below it the face goes on as it meets the floor.
#pragma once

#include <vector>

#include "measure/columns.h"
#include "measure/scan_polygon.h"

namespace muckpile {

class FaceMap {
 public:
  // Lines along x through the rock: `lines` are columns over height and -y whose tops are x [m]
  // (measure/free_face.h). Where a line met no rock, as above the ground, the face is that of the
  // nearest line below that did, else of the nearest one above or beside it. At least one must have
  // met rock. `blocks` is how many there are in all.
  FaceMap(const Columns& lines, size_t blocks);

  // Of the line next to a place [m].
  [[nodiscard]] double x(double y, double z) const { return x_[grid_.at(column(z), row(y))]; }
  // Where the face meets the floor [m].
  [[nodiscard]] double toe(double y) const { return x(y, 0.0); }
  // 1 for each block that a line met first.
  [[nodiscard]] const std::vector<char>& at_face() const { return at_face_; }
  // Heights of the lines in the plane y, from the floor up, and where the face is there (x, z) [m];
  // no higher than lines met rock.
  [[nodiscard]] std::vector<Vec2> section(double y) const;
  // Of the lines that met rock: the middle one's x [m].
  [[nodiscard]] double middle() const { return middle_; }
  [[nodiscard]] double y_low() const { return -(grid_.y0 + grid_.ny * grid_.dy); }
  [[nodiscard]] double y_high() const { return -grid_.y0; }

 private:
  [[nodiscard]] int column(double z) const;
  [[nodiscard]] int row(double y) const;

  ColumnGrid grid_;  // x: height; y: -y
  std::vector<double> x_;
  std::vector<int> met_;  // of each row: how many lines from the floor up, to the last that met rock
  std::vector<char> at_face_;
  double middle_ = 0.0;
};

}  // namespace muckpile
