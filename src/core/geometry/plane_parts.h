// SPDX-License-Identifier: GPL-2.0-or-later
// Rock that planes cut through and through: one tessellation per part, joined again in the planes.
// Scope: serial and deterministic. Seeds next to a plane come in mirror pairs, so that the blocks
// on its two sides face each other as anywhere in the rock. Where they do not match, at crossings,
// their faces in the plane are divided into what each pair of blocks shares: a block may have
// several.
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

/// Two seeds that mirror each other.
struct SeedPair {
  std::size_t plane, part, seed, other_part, other_seed;
};
[[nodiscard]] std::vector<SeedPair> pairs_across(const TessellationOptions& options,
                                                 const std::vector<RockPart>& parts);
/// Puts both seeds of a pair where they and their images are on average.
void make_symmetric(const std::vector<CutPlane>& planes, const SeedPair& pair, Vec3& seed,
                    Vec3& other);

/// The same options for one part alone: the planes become surfaces of its region.
[[nodiscard]] TessellationOptions options_of(const TessellationOptions& options,
                                             const Sides& sides);

/// Makes neighbours of blocks whose free faces overlap in one of the planes.
void join_in_planes(const std::vector<CutPlane>& planes, std::vector<Block>& blocks);

}  // namespace muckpile
