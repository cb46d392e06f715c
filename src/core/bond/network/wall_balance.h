// SPDX-License-Identifier: GPL-2.0-or-later
// Gas that flows round a block on a crushed zone: the share of the wall's load that it balances.
// Scope: a part of the face load that exists only where a face lies on a crushed zone and its block
// has facets. Facets and faces are as they were cut, so no pose enters. Areas in m2.
//
// Gas of one pressure p on the wall N that a block has to a crushed zone, and on those of its faces
// that have come loose from their neighbours, presses the block by p times the sum of A n of all
// its other faces, as A n over a whole block adds up to nothing. Of that, what acts against the
// wall is
//     share = -(sum of fade A n of the others) . N / N^2 = 1 - (sum of fade A n of all) . N / N^2.
// A facet has come loose once it is retired: open by a tenth of its radius, far more than gas needs
// to fill it. Free faces have the atmosphere, walls to other crushed zones the gas there.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "bond/network/facet_history.h"
#include "bond/network/facet_tables.h"

namespace muckpile {

class WallBalance {
 public:
  WallBalance(const FacetTables& tables, std::span<const BoundaryFace> faces);

  /// No block with a wall has facets: nothing is balanced.
  [[nodiscard]] bool empty() const { return beside_.empty(); }
  /// Sets BoundaryFace::load_share of the faces with a hole.
  void share_load(const FacetHistory& history, std::span<BoundaryFace> faces);
  [[nodiscard]] double bytes() const;

 private:
  // Blocks count among those with a wall here; all that is looked up each step lies side by side.
  struct Beside {  // a facet of such a block
    std::uint32_t facet, i, j;
    double area;  // [m2]
    Vec3 normal;
  };
  struct Wall {  // a face with a hole
    std::uint32_t face, block;
    Vec3 sum;         // of A n of the block's wall to that crushed zone [m2]
    double rounding;  // of the block's sum of A n, along `sum` [m4]
  };
  std::vector<Beside> beside_;
  std::vector<Wall> walls_;
  std::vector<Vec3> faces_;  // per block: sum of A n of its faces without a neighbour [m2]
  std::vector<Vec3> backs_;  // per block: that of all faces through which no gas passes [m2]
};

}  // namespace muckpile
