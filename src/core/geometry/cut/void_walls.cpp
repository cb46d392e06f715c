// SPDX-License-Identifier: GPL-2.0-or-later
// Where cells end at the voids of holes.
// Scope: see the header.
#include "geometry/cut/void_walls.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

namespace muckpile {
namespace {

constexpr double kSmall = 1e-5;  // of a block's volume: below it nothing is taken off

double volume_below(const ConvexCell& cell, const Vec3& normal, double at) {
  const std::optional<ConvexCell> part = part_below(cell, at * normal, normal, 0);
  return part ? volume_of(*part) : 0.0;
}

/// Height along the normal below which a cell has so much volume: regula falsi by Illinois' rule.
double height_of(const ConvexCell& cell, const Vec3& normal, double volume, double rounding) {
  constexpr int kMost = 60;
  auto [low, high] = extent(cell.shape, normal);
  double at_low = -volume, at_high = volume_of(cell) - volume, at = high;
  int kept = 0;  // the end that the last cut has left, 1 the lower one
  for (int k = 0; k < kMost; ++k) {
    at = (low * at_high - high * at_low) / (at_high - at_low);
    const double off = volume_below(cell, normal, at) - volume;
    if (std::abs(off) <= rounding) break;
    if (off > 0.0) {
      high = at;
      at_high = off;
      if (kept == 1) at_low *= 0.5;
      kept = 1;
    } else {
      low = at;
      at_low = off;
      if (kept == -1) at_high *= 0.5;
      kept = -1;
    }
  }
  return at;
}

std::optional<ConvexCell> part_in(const ConvexCell& cell, const std::vector<CutPlane>& prism) {
  std::optional<ConvexCell> part = cell;
  for (const CutPlane& plane : prism)
    if (part) part = part_below(std::move(*part), plane.point, plane.normal, 0);
  return part;
}

}  // namespace

void VoidWalls::offer(std::size_t seed, const Polyhedron& shape, double size,
                      std::span<const int> holes, const RingSeed* ring) {
  ConvexCell cell{shape, std::vector<int>(shape.faces.size(), 0)};
  std::optional<Carved> most;
  for (const int h : holes) {
    const std::vector<CutPlane>& planes = prisms_[static_cast<std::size_t>(h)];
    if (planes.empty()) continue;
    std::optional<ConvexCell> inside = part_in(cell, planes);
    const double prism = inside ? volume_of(*inside) : 0.0;
    if (!(prism > 0.0)) continue;
    prism_volume_[static_cast<std::size_t>(h)] += prism;
    if (most && most->prism >= prism) continue;
    most = Carved{seed, {}, std::move(*inside), size, 0.0, prism, {h, {}}, 0.0};
  }
  if (!most || most->prism < kSmall * size * size * size) return untouched_.push_back(seed);
  most->volume = volume_of(cell);
  most->cell = std::move(cell);
  if (ring && ring->hole == most->wall.hole) {
    constexpr double kSame = 1e-3;  // of what is taken off
    const std::optional<ConvexCell> off =
        part_below(most->cell, ring->wall.point, ring->wall.normal, 0);
    most->taken = off ? volume_of(*off) : 0.0;
    most->is_own = std::abs(most->taken - most->prism) <= kSame * most->prism;
    if (most->is_own) most->wall.plane = ring->wall;
  }
  carved_.push_back(std::move(*most));
}

/// The direction of the wall.
void VoidWalls::choose(Carved& one) const {
  constexpr double kCoarse = 1e-3, kAlong = 0.2;  // of the volume; cosine
  const std::vector<CutPlane>& prism = prisms_[static_cast<std::size_t>(one.wall.hole)];
  const Vec3 outward = (centroid_of(one.cell) - centroid_of(one.in_prism)).stableNormalized();
  std::vector<Vec3> normals{outward};
  for (const CutPlane& side : prism)
    if (side.normal.dot(outward) > kAlong) normals.push_back(side.normal);
  double most = -1.0;
  for (const Vec3& normal : normals) {
    const double at = height_of(one.cell, normal, one.prism, kCoarse * one.prism);
    const double right = volume_below(one.in_prism, normal, at);
    if (right <= most) continue;
    most = right;
    one.wall.plane = {at * normal, normal};
  }
  one.taken = one.prism;
}

/// Lets the cells at a hole make up for what others take off too much or not at all.
void VoidWalls::balance(int hole) {
  constexpr double kLeast = 0.5, kMost = 1.5;        // of what the prism has of a cell
  constexpr double kFine = 1e-9, kMostOfCell = 0.9;  // of a cell's volume
  constexpr double kThinnest = 0.1;  // 3 V / A over the block size, below which rock is no block
  double missing = prism_volume_[static_cast<std::size_t>(hole)], adjustable = 0.0;
  for (Carved& one : carved_) {
    if (one.wall.hole != hole) continue;
    const Vec3& normal = one.wall.plane.normal;
    const std::optional<ConvexCell> rock = part_below(one.cell, one.wall.plane.point, -normal, 0);
    if (!rock || mean_radius(rock->shape) < kThinnest * one.size) {
      one.taken = one.volume;
      one.is_own = true;
      one.wall.plane.point = (extent(one.cell.shape, normal).second + one.size) * normal;
    }
    missing -= one.taken;
    adjustable += one.is_own ? 0.0 : one.taken;
  }
  const double factor =
      adjustable > 0.0 ? std::clamp(1.0 + missing / adjustable, kLeast, kMost) : 1.0;
  for (Carved& one : carved_) {
    if (one.wall.hole != hole || one.is_own) continue;
    const Vec3& normal = one.wall.plane.normal;
    const double volume = std::min(factor * one.taken, kMostOfCell * one.volume);
    one.wall.plane.point = height_of(one.cell, normal, volume, kFine * one.volume) * normal;
  }
}

void VoidWalls::fit(std::vector<VoidWall>& walls) {
  for (Carved& one : carved_)
    if (!one.is_own) choose(one);
  for (std::size_t h = 0; h < prism_volume_.size(); ++h)
    if (prism_volume_[h] > 0.0) balance(static_cast<int>(h));
  for (const std::size_t seed : untouched_) walls[seed].hole = -1;
  for (const Carved& one : carved_) walls[one.seed] = one.wall;
}

std::vector<CutPlane> round_prism(const Hole& hole) {
  constexpr int kSides = 16;  // four times as many as there are quarters of a hole on two walls
  constexpr double kStep = 2.0 * std::numbers::pi / kSides;
  const Vec3 along = (hole.collar - hole.toe).normalized();
  const Vec3 x = Vec3::UnitX() - along.x() * along, y = Vec3::UnitY() - along.y() * along;
  const Vec3 first = (x.norm() > 0.5 ? x : y).normalized(), second = along.cross(first);
  const double apothem = hole.radius * std::sqrt(0.5 * kStep / std::tan(0.5 * kStep));
  std::vector<CutPlane> planes;
  for (int k = 0; k < kSides; ++k) {
    const double angle = kStep * (k + 0.5);
    const Vec3 out = std::cos(angle) * first + std::sin(angle) * second;
    planes.push_back({hole.toe + apothem * out, out});
  }
  planes.push_back({hole.toe, -along});
  planes.push_back({hole.collar, along});
  return planes;
}

}  // namespace muckpile
