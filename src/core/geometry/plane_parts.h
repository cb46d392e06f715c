// SPDX-License-Identifier: GPL-2.0-or-later
// Rock that planes cut through and through: one tessellation per part, joined again in the planes.
// Scope: serial and deterministic. Blocks on the two sides of a plane do not match; their faces in
// it are divided into what each pair of them shares, so a block may have several faces in a plane.
#pragma once

#include <vector>

#include "geometry/tessellation.h"

namespace muckpile {

/// Which side of each plane a point is on.
using Sides = std::vector<bool>;
[[nodiscard]] Sides sides_of(const std::vector<CutPlane>& planes, const Vec3& point);

/// The parts that hold a seed, or that a few times as many random points find, with their seeds.
struct RockPart {
  Sides sides;
  std::vector<Vec3> seeds;
};
[[nodiscard]] std::vector<RockPart> parts_of(const TessellationOptions& options);

/// The same options for one part alone: the planes become surfaces of its region.
[[nodiscard]] TessellationOptions options_of(const TessellationOptions& options,
                                             const Sides& sides);

/// Makes neighbours of blocks whose free faces overlap in one of the planes.
void join_in_planes(const std::vector<CutPlane>& planes, std::vector<Block>& blocks);

}  // namespace muckpile
