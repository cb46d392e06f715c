// SPDX-License-Identifier: GPL-2.0-or-later
// Seeds in rings around holes that are narrow against their blocks, and the planes that cut the
// void out of their cells.
// Scope: Voronoi cut. Start positions that no sweep moves; from the options alone, so they are the
// same on any number of ranks.
//
// A plane between a seed and its image cannot lie nearer to the axis than half the seed's distance,
// so a hole not wider than its blocks cannot be cut that way. Here six or eight seeds stand around
// the axis, level above level, at the same angles: their cells meet at the axis like slices of a
// cake, and each is cut at one side of a prism with the cylinder's cross section. The sides of all
// levels are the same, so the void is that prism. A ring of seeds beyond each end makes the end
// plane.
//   With n cells of volume s^3 in levels of height h around a hole of radius a the ring reaches to
// R, and its seeds stand half a block inside:
//     pi (R^2 - a^2) h / n = s^3,     rho = R - s/2
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "geometry/cut/tessellation.h"

namespace muckpile {

struct RingSeed {
  Vec3 at = Vec3::Zero();  // [m]
  int hole = -1;           // whose void its cell ends at; -1 beyond the ends of a hole
  CutPlane wall;           // side of the void's prism; unit normal, away from the axis
  double size = 0.0;       // of its block [m]
};

class HoleRings {
 public:
  HoleRings() = default;
  // Throws InputError: blocks wider than kCoarsest radii, a hole shorter than a quarter of its
  // blocks, and two holes whose rings would meet.
  explicit HoleRings(const TessellationOptions& options);

  // Those of a part of the rock between planes, whose unit normals look out: the seeds, in the part
  // or not, whose cells make a block there. What the cells of the others have there goes to the
  // cells beside them. `one_at_least`: of those that have rock there the largest, if none makes a
  // block. (ring_parts.cpp)
  [[nodiscard]] HoleRings within(const std::vector<CutPlane>& bounds,
                                 bool one_at_least = false) const;

  // Whether rings stand around a hole, the alternative to images of the seeds behind its wall.
  [[nodiscard]] bool around(std::size_t hole) const {
    return hole < reach_.size() && reach_[hole] > 0.0;
  }
  // No other seed is so near to the axis of a hole [m]; 0 where there are no rings.
  [[nodiscard]] double reach(std::size_t hole) const { return around(hole) ? reach_[hole] : 0.0; }
  void drop(std::size_t seed) { seeds_.erase(seeds_.begin() + static_cast<std::ptrdiff_t>(seed)); }
  [[nodiscard]] double largest_reach() const;                        // of all holes [m]
  [[nodiscard]] std::size_t holes() const { return reach_.size(); }  // none without rings
  [[nodiscard]] const std::vector<RingSeed>& seeds() const { return seeds_; }
  // The sides and ends of the prism that is the void of a hole with rings; unit normals look out.
  // No end where the rock beyond it goes with the void.
  [[nodiscard]] const std::vector<CutPlane>& prism(std::size_t hole) const { return prisms_[hole]; }

 private:
  Vec3 lo_ = Vec3::Zero(), hi_ = Vec3::Zero();  // corners of the box [m]
  std::vector<double> reach_;                   // per hole [m]; empty without rings
  std::vector<RingSeed> seeds_;                 // in the rock
  std::vector<std::vector<CutPlane>> prisms_;   // per hole
};

// What is left of a cell of a ring, over the least that makes a block: 3 V / A of kThinnestPart and
// V^(1/3) of half a block size.
[[nodiscard]] double worth_as_block(const RingSeed& seed, const Polyhedron& rock);

// Where a cell ends at a void: its hole, and the plane, whose unit normal looks away from the void.
struct VoidWall {
  int hole = -1;  // -1: nowhere
  CutPlane plane{};
};

// Blocks over radius of a hole that may get rings (TessellationOptions::rings_from): from the first
// two, where images make the void of graded blocks too large and then fail, up to the last, to
// which the volume that the wall sweeps is right within 5 % (docs/theory/wall.md).
inline constexpr double kImagesTooLarge = 1.5, kImagesFail = 2.0, kCoarsest = 6.0;

// What lies behind the wall of a cell is void, for the cells beside it, too: divides those faces of
// block `number`, and says that the part is on the hole. `walls`: per seed.
void open_to_voids(std::span<const VoidWall> walls, int number, Block& block);

// Faces in a plane of the cut with nothing behind them that look into the void of a hole are on
// that hole: the two sides of a plane are cut each for itself, so their voids differ a little.
void open_planes_to_voids(const TessellationOptions& options, std::vector<Block>& blocks);

}  // namespace muckpile
