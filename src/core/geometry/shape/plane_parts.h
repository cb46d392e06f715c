// SPDX-License-Identifier: GPL-2.0-or-later
// Rock that planes cut through and through: the parts between them, one tessellation each.
// Scope: serial and deterministic. Parts are convex, and their cells end at their planes, whatever
// the seeds are. Seeds next to a plane come in mirror pairs, so that the blocks on its two sides
// face each other as anywhere in the rock. joined_parts.h makes one rock of them again.
#pragma once

#include <vector>

#include "geometry/cut/ground.h"
#include "geometry/cut/tessellation.h"
#include "geometry/shape/convex_cell.h"

namespace muckpile {

/// A convex part of the box between planes, with its seeds.
struct RockPart {
  std::vector<CutPlane> bounds;  // the planes around it; unit normals look out
  std::vector<Vec3> seeds;       // none where those of rings around holes have all of it
};

struct RockParts {
  std::vector<RockPart> parts;
  std::size_t merged = 0;  // parts too thin for a block, not cut off from what is beside them
  // Left out since no seed falls into them, though samples find rock there, and its volume [m3].
  std::size_t lost = 0;
  double lost_volume = 0.0;
};

/// Cuts the box by one plane after the other. A plane does not cut off a part whose 3 V / A is
/// below kThinnestPart of the block size there: the larger part, convex as it was, keeps it.
[[nodiscard]] RockParts parts_of(const TessellationOptions& options);

/// Whether a plane would cut off a part that is too thin.
[[nodiscard]] bool cuts_sliver_off(const HalfCells& halves, const Ground& ground, double thinnest);

/// The seeds of the rings around holes that have a block in a part.
[[nodiscard]] HoleRings rings_in(const HoleRings& rings, const RockPart& part);

/// Two seeds that mirror each other.
struct SeedPair {
  std::size_t plane, part, seed, other_part, other_seed;
};
[[nodiscard]] std::vector<SeedPair> pairs_across(const TessellationOptions& options,
                                                 const std::vector<RockPart>& parts);
/// Puts both seeds of a pair where they and their images are on average, unless that is outside
/// the part of one, or no rock: a crushed zone may lie across the plane.
void make_symmetric(const Ground& ground, const CutPlane& plane, const RockPart& part, Vec3& seed,
                    const RockPart& other_part, Vec3& other);

/// The same options for one part alone.
[[nodiscard]] TessellationOptions options_of(const TessellationOptions& options,
                                             const RockPart& part);

}  // namespace muckpile
