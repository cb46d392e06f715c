// SPDX-License-Identifier: GPL-2.0-or-later
// The joints of the rock by geometry: which faces of two blocks are one and the same.
// Scope: the start configuration, of the model without images; faces of cuts that give both blocks
// of a joint the same polygon, as those of create_blocks do.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "io/blocks_file.h"

namespace muckpile {

struct RockFace {
  size_t block;
  int face;                     // number in the block's polyhedron
  std::optional<size_t> other;  // block behind it; none: free, supported or on a crushed zone
  std::vector<Vec3> corners;    // [m]
  Vec3 centroid, normal;        // [m], unit and outward from `block`
  double area;                  // [m2]
};

// Each joint once, from the block that comes first, and the faces with nothing behind, in the order
// of the blocks. Faces too small for a joint are left out.
std::vector<RockFace> faces_of_rock(const std::vector<StartBlock>& blocks);

// Where a plane with this unit normal, so far from the origin along it, cuts a face; none where it
// does not, or runs along it [m].
std::optional<std::pair<Vec3, Vec3>> cut_of(const RockFace& face, const Vec3& normal,
                                            double distance);

}  // namespace muckpile
