// SPDX-License-Identifier: GPL-2.0-or-later
// Vertical columns through posed blocks: the top surface and the length of rock in each column.
// Scope: exact for the polyhedra at the column's centre line; overlapping blocks count twice in the
// length.
#pragma once

#include <limits>
#include <vector>

#include "io/blocks_file.h"
#include "io/snapshot.h"

namespace muckpile {

// A rectangle of the x-y plane cut into cells; cell (i, j) has its centre at (x(i), y(j)) [m].
struct ColumnGrid {
  double x0, y0;  // lower corner [m]
  double dx, dy;  // cell [m]
  int nx, ny;
  [[nodiscard]] double x(int i) const { return x0 + (i + 0.5) * dx; }
  [[nodiscard]] double y(int j) const { return y0 + (j + 0.5) * dy; }
  [[nodiscard]] size_t at(int i, int j) const {
    return static_cast<size_t>(j) * static_cast<size_t>(nx) + static_cast<size_t>(i);
  }
  [[nodiscard]] size_t cells() const { return static_cast<size_t>(nx) * static_cast<size_t>(ny); }
};

// Cells of about `cell` [m] over [x_low, x_high] x [y_low, y_high]; x = 0 falls on a cell border, y
// is filled exactly. Throws InputError if the grid would have more than 50 million cells.
ColumnGrid column_grid(double x_low, double x_high, double y_low, double y_high, double cell);

// A face this close to upright covers no column: 1e-9 of its area is far below one cell.
inline constexpr double kUpright = 1e-9;

inline constexpr double kNoRock = -std::numeric_limits<double>::infinity();

struct Columns {
  ColumnGrid grid;
  std::vector<double> top;     // highest point of rock [m], kNoRock where there is none
  std::vector<int> top_block;  // index of the block it belongs to, -1 where there is none
  std::vector<double> length;  // rock in the column [m]
};

// Columns through the blocks whose `keep` is not zero.
Columns columns_through(const ColumnGrid& grid, const std::vector<StartBlock>& blocks,
                        const std::vector<BlockState>& states, const std::vector<char>& keep);

// Their tops alone, at a fraction of the time: `length` is empty. Blocks that lie deep below others
// are left out as soon as these hide them. Of blocks with equally high tops in a column, any is its
// top_block.
Columns tops_through(const ColumnGrid& grid, const std::vector<StartBlock>& blocks,
                     const std::vector<BlockState>& states, const std::vector<char>& keep);

// Extent of all vertices.
struct Extent {
  Vec3 low, high;  // [m]
};
Extent extent_of(const std::vector<StartBlock>& blocks, const std::vector<BlockState>& states);

}  // namespace muckpile
