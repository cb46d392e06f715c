// SPDX-License-Identifier: GPL-2.0-or-later
// Cuts a region of rock into graded Voronoi blocks around crushed zones (cells by voro++).
// Limits: one connected box, clipped by an optional region; blocks stay convex.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "geometry/block_model.h"
#include "geometry/size/size_law.h"

namespace muckpile {

// A rough surface of the rock, to which planes are fitted as wide as a block.
struct FittedSurface {
  // Feet of the perpendiculars from a point in the rock to these planes, within `cutoff` [m].
  std::function<std::vector<Vec3>(const Vec3& point, double cutoff)> feet;
  std::function<double(const Vec3& point)> height;  // distance, positive out of the rock [m]
  std::function<Vec3(const Vec3& point)> closest;   // point of the surface itself
};

// A region inside the box, for rock that is not a box. Both functions or none. Plane faces come out
// plane. Inner edges (toe of a bench) lose a chamfer of about one block; air features narrower than
// a few blocks are not resolved.
struct RegionQuery {
  std::function<bool(const Vec3& point)> inside;
  // The closest point of each smooth piece of the region's surface that lies within `cutoff` [m]
  // of `point`; several near a convex edge of the rock, all different. No box walls.
  std::function<std::vector<Vec3>(const Vec3& point, double cutoff)> surface_points;
  // Surfaces that `inside` heeds as well, but that blocks follow by fitted planes.
  std::vector<FittedSurface> fitted{};
};

// Plane that the cut follows: blocks end on both sides of it.
struct CutPlane {
  Vec3 point = Vec3::Zero();    // [m]
  Vec3 normal = Vec3::UnitZ();  // of any length but 0
};

// Least 3 V / A, over the block size there, of what a plane may cut off the rock, and of blocks
// between joint sets: a plate of 0.13 sizes, a needle of 0.27 sizes across. Ours: much thinner ones
// take steps much shorter than their neighbours', and small spheres cannot fill them.
inline constexpr double kThinnestPart = 0.2;

// Several processes that share the sweeps. Each has the same options but for `rank`.
struct SweepTeam {
  int rank = 0, ranks = 1;
  // What each has given, one after the other in the order of ranks, to all. Collective.
  std::function<std::vector<double>(const std::vector<double>& mine)> gather;
};

class SizeFactor;

struct TessellationOptions {
  Vec3 lo = Vec3::Zero();  // box corners [m]
  Vec3 hi = Vec3::Zero();
  std::vector<Hole> holes;
  // Further axes (both ends) that the size law counts from; no rock is removed there.
  std::vector<std::pair<Vec3, Vec3>> fine_axes;
  SizeLaw size = SizeLaw::uniform(1.0);
  bool superpose = false;  // sizes from all holes (SizeLaw::superposed), not from the nearest
  std::shared_ptr<const SizeFactor> factor{};  // of the size by place; none: 1 everywhere
  unsigned long seed = 1;
  int sweeps = 20;  // size-weighted Lloyd sweeps
  std::size_t max_blocks = 1000000;
  RegionQuery region;
  // Each goes through all of the rock, but cuts no sliver off (kThinnestPart). A crushed zone that
  // crosses a plane is carved on each side for itself, and all that looks into its void is on it.
  std::vector<CutPlane> planes;
  bool rings = true;        // of seeds around holes narrow against their blocks (hole_rings.h)
  double rings_from = 1.5;  // blocks over radius of a hole that get them
  SweepTeam team;
};

struct TessellationStatistics {
  double expected_blocks = 0.0;         // integral of dV / size^3 over the rock
  double box_volume = 0.0;              // [m3]
  double block_volume = 0.0;            // sum over blocks [m3]
  double void_volume = 0.0;             // box - blocks: crushed zones and what the region cuts off
  std::vector<double> hole_volume;      // per hole, enclosed by its faces [m3]
  std::vector<double> hole_area;        // per hole, sum of its face areas [m2]
  std::vector<double> cylinder_volume;  // per hole, of the ideal cylinder inside the box [m3]
  double smallest_face_area_ratio = 0.0;  // min over faces of area / V^(2/3) of its block [-]
  double median_size_ratio = 0.0;         // median over blocks of V^(1/3) / target size [-]
  std::size_t faces_collapsed = 0;        // faces at rounding level that only one block had
  std::size_t merged_parts = 0;  // slivers between planes that stay with what is beside them
  std::size_t lost_parts = 0;    // between planes, with rock that no seed fell into: left out
  double lost_volume = 0.0;      // of rock in them, sampled [m3]
};

struct Tessellation {
  std::vector<Block> blocks;  // in the order of their seeds
  TessellationStatistics statistics;
};

// Expected number of blocks [-]; cheap, nothing is allocated. Stops counting above `give_up`.
[[nodiscard]] double expected_block_count(const TessellationOptions& options, double give_up);

// For the makers of a cut: expected number of blocks; throws InputError as tessellate() does.
[[nodiscard]] double checked_block_count(const TessellationOptions& options);
// For the makers of a cut: all of result.statistics that follows from its blocks.
void add_statistics(const TessellationOptions& options, Tessellation& result);

// The same options give the same blocks. Faces between two blocks agree to rounding; in a plane of
// the cut a block has one face for each block behind it.
// Throws InputError: empty box, plane without normal, hole axis outside the box, blocks at a hole
// larger than its diameter without rings, what hole_rings.h refuses, half a region query, or more
// blocks expected than max_blocks.
// With a team, the other members call share_sweeps(); the blocks are the same to the last bit.
[[nodiscard]] Tessellation tessellate(const TessellationOptions& options);
// The sweeps of tessellate() without its blocks. Throws as it does before the first sweep.
void share_sweeps(const TessellationOptions& options);

}  // namespace muckpile
