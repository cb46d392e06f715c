// SPDX-License-Identifier: GPL-2.0-or-later
// Blocks whose faces lie in one plane, on its two sides, but do not match: each face is divided
// into the polygons that it shares with each block behind.
// Scope: serial and deterministic; faces in a plane are found by the caller.
#pragma once

#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include "geometry/block_model.h"
#include "geometry/shape/polygon.h"

namespace muckpile {

/// A face in the plane as a polygon that turns about the plane's normal.
struct PlaneFace {
  std::size_t block, face;
  Polygon polygon;
  Vec2 lo, hi;
  double area;
};

/// `side` 1: the block lies below the plane, its face looks along the normal; -1: above.
[[nodiscard]] PlaneFace plane_face(const PlaneFrame& frame, const std::vector<Block>& blocks,
                                   std::size_t block, std::size_t face, double side);

/// Piece of a face and the block behind it.
struct Piece {
  std::vector<Vec3> polygon;  // counter-clockwise seen from outside the face's block
  int behind;
};
using Pieces = std::map<std::pair<std::size_t, std::size_t>, std::vector<Piece>>;  // block, face

/// Adds what each face below shares with each face above. Overlaps below 1e-9 of the smaller face
/// are rounding and left out. The faces are put into order.
void share_faces(const PlaneFrame& frame, std::vector<PlaneFace>& below,
                 std::vector<PlaneFace>& above, Pieces& pieces);

/// Makes the blocks neighbours. A face that has one block behind all of it keeps its corners; what
/// no block is behind becomes free faces, so that blocks stay closed. Throws InputError if blocks
/// overlap.
void divide_faces(const Pieces& pieces, std::vector<Block>& blocks);

}  // namespace muckpile
