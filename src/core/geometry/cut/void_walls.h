// SPDX-License-Identifier: GPL-2.0-or-later
// Where the cells of a part of the rock between planes end at the voids of holes.
// Scope: one part, its cells offered one after the other; serial and deterministic.
//
// Where planes cross a hole some seeds of its rings make no block in the part, and the cells beside
// them reach over several sides of the void's prism, or into it; of a hole without rings few cells
// of the part are at the void. A cell stays convex: one plane takes off it as much as the prism has
// of it. The void of the part then has the prism's volume, and of all directions of sides and ends
// the plane has the one in which it takes off most of the prism's part.
#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "geometry/cut/hole_rings.h"
#include "geometry/shape/convex_cell.h"

namespace muckpile {

class VoidWalls {
 public:
  // The prism of each hole; no planes where its void is not made here.
  explicit VoidWalls(std::vector<std::vector<CutPlane>> prisms)
      : prisms_(std::move(prisms)), prism_volume_(prisms_.size(), 0.0) {}

  // The cell of a seed before anything is taken off it, the block size there [m], the holes that
  // may reach into it, and the wall of a seed of a ring, else none.
  void offer(std::size_t seed, const Polyhedron& cell, double size, std::span<const int> holes,
             const RingSeed* ring);

  // Puts the walls of the cells offered among those of all seeds. A cell that would leave no block
  // goes with the void as a whole; the others make up for it.
  void fit(std::vector<VoidWall>& walls);

 private:
  struct Carved {
    std::size_t seed;
    ConvexCell cell, in_prism;
    double size, volume, prism;  // [m], of the cell and of its part in the prism [m3]
    VoidWall wall;
    double taken;         // [m3]
    bool is_own = false;  // the wall is a side of the prism
  };
  void choose(Carved& one) const;
  void balance(int hole);

  std::vector<std::vector<CutPlane>> prisms_;
  std::vector<double> prism_volume_;  // of each hole in all cells [m3]
  std::vector<std::size_t> untouched_;
  std::vector<Carved> carved_;
};

// Around a void as large as the cylinder; unit normals look out.
[[nodiscard]] std::vector<CutPlane> round_prism(const Hole& hole);

}  // namespace muckpile
