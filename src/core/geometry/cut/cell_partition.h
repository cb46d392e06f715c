// SPDX-License-Identifier: GPL-2.0-or-later
// A box that planes have divided, cell by cell, into rock and voids, and the blocks this makes.
// Scope: every plane divides one cell, so a face of its two halves is met by faces of cells that
// came from these halves only: neighbours are found without search and without tolerance.
#pragma once

#include <optional>
#include <vector>

#include "geometry/block_model.h"
#include "geometry/cut/tessellation.h"
#include "geometry/shape/convex_cell.h"

namespace muckpile {

inline constexpr int kRock = 0;  // filling of a cell; voids have the code of faces against them

class CellPartition {
 public:
  /// Divides a cell that is not finished; none if the plane does not pass through it.
  [[nodiscard]] std::optional<HalfCells> divide(const ConvexCell& cell, const CutPlane& plane);

  /// No plane will divide this cell any more. `filling`: kRock, kFreeFace or hole_face(h).
  void finish(ConvexCell cell, int filling);

  /// Volume of the finished cells with this filling [m3].
  [[nodiscard]] double volume_filled_with(int filling) const;

  /// The rock. Facets are the polygons that two blocks share; target sizes are not set.
  [[nodiscard]] std::vector<Block> blocks() const;

 private:
  struct Finished {
    ConvexCell cell;
    int filling;
  };
  std::vector<CutPlane> planes_;
  std::vector<Finished> cells_;
};

}  // namespace muckpile
