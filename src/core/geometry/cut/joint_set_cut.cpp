// SPDX-License-Identifier: GPL-2.0-or-later
// Graded joint sets: cells of a lattice of three sets, halved until they have the size asked for.
// Scope: deterministic and serial. Which planes there are: joint_lattice.h.
#include "geometry/cut/joint_set_cut.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "geometry/cut/cell_partition.h"
#include "geometry/cut/fitted_cutting.h"
#include "geometry/cut/ground.h"
#include "geometry/cut/joint_lattice.h"
#include "geometry/cut/region_cutting.h"
#include "geometry/holes/hole_carving.h"
#include "geometry/holes/hole_surface.h"
#include "geometry/shape/plane_parts.h"

namespace muckpile {
namespace {

// A cell is halved above sqrt(2) of the volume asked for: its halves are then as far below it.
constexpr double kMostBlocks = std::numbers::sqrt2;

class Cutting {
 public:
  Cutting(const TessellationOptions& rock, const JointSetCut& how)
      : rock_(rock),
        sliver_(how.sliver),
        ground_(rock),
        lattice_(lattice_in(rock, how)),
        scales_(rock.holes.size(), 1.0) {}

  [[nodiscard]] std::vector<Block> run();
  [[nodiscard]] const std::vector<double>& cylinder_volumes() const { return cylinder_volumes_; }
  [[nodiscard]] std::size_t merged_parts() const { return merged_parts_; }

 private:
  [[nodiscard]] std::vector<ConvexCell> parts_between_planes();
  [[nodiscard]] double blocks_in(const ConvexCell& cell) const;
  [[nodiscard]] std::vector<std::size_t> holes_in(const ConvexCell& cell) const;
  [[nodiscard]] bool is_sliver(const ConvexCell& cell) const;
  [[nodiscard]] std::optional<ConvexCell> rock_of(const ConvexCell& cell) const;
  [[nodiscard]] bool is_thin(const HalfCells& halves, const LatticeSet& set) const;
  void refine(const LatticeCell& whole);
  [[nodiscard]] bool part_by_flat_surface(const LatticeCell& from, std::vector<LatticeCell>& open);
  [[nodiscard]] bool part_by_curved_surface(const ConvexCell& from);
  [[nodiscard]] bool halve(LatticeCell from, std::vector<LatticeCell>& open);
  [[nodiscard]] bool is_left_by_fitted(ConvexCell& cell);
  void finish(ConvexCell cell);
  void carve(CellPartition& partition) const;
  void fit_prisms();
  [[nodiscard]] std::vector<HoleCarving> prisms() const;

  const TessellationOptions& rock_;
  const double sliver_;
  const Ground ground_;
  const Lattice lattice_;
  CellPartition partition_;
  std::vector<HoleCarving> zones_;
  double beyond_walls_ = 0.0;  // how far a prism's edges stick out of its cylinder at most [m]
  std::vector<ConvexCell> at_holes_;  // across a crushed zone's wall, of final size
  std::vector<double> scales_, cylinder_volumes_;
  std::size_t merged_parts_ = 0;
};

std::vector<HoleCarving> Cutting::prisms() const {
  std::vector<HoleCarving> carvings;
  for (std::size_t h = 0; h < rock_.holes.size(); ++h) {
    const Hole& hole = rock_.holes[h];
    const Vec3 on_wall = hole.toe + 0.5 * (hole.collar - hole.toe) +
                         hole.radius * (hole.collar - hole.toe).normalized().unitOrthogonal();
    carvings.emplace_back(hole, static_cast<int>(h), ground_.size(on_wall), scales_[h]);
  }
  return carvings;
}

std::vector<ConvexCell> Cutting::parts_between_planes() {
  std::vector<ConvexCell> parts{box_cell(rock_.lo, rock_.hi)};
  for (const CutPlane& plane : rock_.planes) {
    const CutPlane unit{plane.point, plane.normal.normalized()};
    std::vector<ConvexCell> next;
    for (const ConvexCell& part : parts) {
      const auto tried = divided(part, unit.point, unit.normal, 0);
      const bool thin = tried && cuts_sliver_off(*tried, ground_, sliver_);
      merged_parts_ += thin ? 1 : 0;
      if (!tried || thin) {
        next.push_back(part);
        continue;
      }
      const auto halves = partition_.divide(part, unit);
      next.push_back(halves->below);
      next.push_back(halves->above);
    }
    parts = std::move(next);
  }
  return parts;
}

/// The crushed zones that reach into a cell.
std::vector<std::size_t> Cutting::holes_in(const ConvexCell& cell) const {
  std::vector<std::size_t> found;
  if (zones_.empty()) return found;
  const Vec3 middle = centroid_of(cell);
  double reach = 0.0;
  for (const Vec3& v : cell.shape.vertices) reach = std::max(reach, (v - middle).norm());
  std::vector<int> near;
  ground_.holes_near(middle, reach + beyond_walls_, near);
  for (const int h : near) {
    const auto zone = static_cast<std::size_t>(h);
    if (zones_[zone].place_of(cell) != HoleCarving::Place::outside) found.push_back(zone);
  }
  return found;
}

/// What fitted surfaces leave of a cell of some blocks; none if nothing. Of larger ones the whole.
std::optional<ConvexCell> Cutting::rock_of(const ConvexCell& cell) const {
  constexpr double kMostParted = 3.0;
  if (rock_.region.fitted.empty()) return cell;
  const double size = ground_.size(centroid_of(cell));
  if (volume_of(cell) > kMostParted * size * size * size) return cell;
  FittedPart part = rock_part(rock_.region, cell, size);
  return part.is_rock ? std::optional(std::move(part.cell)) : std::nullopt;
}

/// Volume of the rock in a cell over that of a block there, for each block that will come of it.
double Cutting::blocks_in(const ConvexCell& cell) const {
  const auto left = rock_of(cell);
  if (!left) return 0.0;
  const MassProperties whole = mass_properties(left->shape);
  double most = std::pow(ground_.size(whole.centroid), -3.0) * whole.volume;
  for (const std::size_t h : holes_in(cell)) {
    const HoleCarving::Rock rock = zones_[h].rock_of(cell);
    most = std::min(most, rock.volume / std::pow(ground_.size(rock.centroid), 3.0) /
                              static_cast<double>(rock.parts));
  }
  return most;
}

bool Cutting::is_sliver(const ConvexCell& cell) const {
  return mean_radius(cell.shape) < sliver_ * ground_.size(centroid_of(cell));
}

bool Cutting::is_thin(const HalfCells& halves, const LatticeSet& set) const {
  for (const ConvexCell* half : {&halves.below, &halves.above}) {
    const auto rock = rock_of(*half);
    if (!rock && is_film(*half, ground_.size(centroid_of(*half)))) return true;
    if (!rock) continue;
    const auto [from, to] = extent(rock->shape, set.normal);
    const double thinnest = 2.0 * sliver_ * set.relative * ground_.size(centroid_of(*rock));
    if (is_sliver(*rock) || to - from < thinnest) return true;
  }
  return false;
}

bool Cutting::halve(LatticeCell from, std::vector<LatticeCell>& open) {
  if (blocks_in(from.cell) <= kMostBlocks) return false;
  const double size = ground_.size(centroid_of(from.cell));
  while (const auto k = widest_set(lattice_, from, size)) {
    const LatticeSet& set = lattice_[*k];
    auto& between = from.between[*k];
    const double u = plane_between(between);
    const CutPlane plane{(set.start + u * set.spacing) * set.normal, set.normal};
    auto halves = divided(from.cell, plane.point, plane.normal, 0);
    if (!halves || is_thin(*halves, set)) {
      const auto [low, high] = extent(from.cell.shape, set.normal);
      const bool mostly_above = 0.5 * (low + high) > set.start + u * set.spacing;
      (mostly_above ? between.first : between.second) = u;
      continue;
    }
    halves = partition_.divide(from.cell, plane);
    LatticeCell below{std::move(halves->below), from.between};
    LatticeCell above{std::move(halves->above), from.between};
    below.between[*k].second = above.between[*k].first = u;
    open.push_back(std::move(above));
    open.push_back(std::move(below));
    return true;
  }
  return false;
}

bool Cutting::part_by_flat_surface(const LatticeCell& from, std::vector<LatticeCell>& open) {
  if (!rock_.region.inside) return false;
  auto plane = surface_through(rock_.region, from.cell, SurfaceKind::flat);
  if (!plane) plane = flat_fitted_through(rock_.region, from.cell);
  if (!plane) return false;
  auto halves = partition_.divide(from.cell, *plane);
  open.push_back({std::move(halves->above), from.between});
  open.push_back({std::move(halves->below), from.between});
  return true;
}

/// One tangent plane for a cell of final size; a sliver of rock is left out.
bool Cutting::part_by_curved_surface(const ConvexCell& from) {
  if (!rock_.region.inside) return false;
  const auto plane = surface_through(rock_.region, from, SurfaceKind::any);
  if (!plane) return false;
  auto halves = partition_.divide(from, *plane);
  for (ConvexCell* half : {&halves->below, &halves->above}) {
    if (is_sliver(*half) && rock_.region.inside(centroid_of(*half))) {
      partition_.finish(std::move(*half), kFreeFace);
    } else {
      finish(std::move(*half));
    }
  }
  return true;
}

/// Cuts off what lies beyond fitted surfaces; a sliver of rock is left out.
bool Cutting::is_left_by_fitted(ConvexCell& cell) {
  if (rock_.region.fitted.empty()) return true;
  const FittedPart part = rock_part(rock_.region, cell, ground_.size(centroid_of(cell)));
  if (!part.is_rock) return false;
  for (const CutPlane& plane : part.planes) {
    auto halves = partition_.divide(cell, plane);
    if (!halves) continue;
    partition_.finish(std::move(halves->above), kFreeFace);
    cell = std::move(halves->below);
  }
  constexpr double kThinnest = 0.5;  // of the sliver elsewhere: dropping more would leave steps
  return mean_radius(cell.shape) >= kThinnest * sliver_ * ground_.size(centroid_of(cell)) ||
         !is_near_fitted(rock_.region, cell);
}

/// A cell of final size: void, at a crushed zone, or rock.
void Cutting::finish(ConvexCell cell) {
  if (!is_left_by_fitted(cell)) return partition_.finish(std::move(cell), kFreeFace);
  if (rock_.region.inside && !rock_.region.inside(centroid_of(cell)))
    return partition_.finish(std::move(cell), kFreeFace);
  if (!holes_in(cell).empty()) return at_holes_.push_back(std::move(cell));
  partition_.finish(std::move(cell), kRock);
}

void Cutting::refine(const LatticeCell& whole) {
  std::vector<LatticeCell> open{whole};
  while (!open.empty()) {
    const LatticeCell cell = std::move(open.back());
    open.pop_back();
    if (rock_.region.inside && is_far_outside(rock_.region, cell.cell) &&
        !is_near_fitted(rock_.region, cell.cell)) {
      partition_.finish(cell.cell, kFreeFace);
      continue;
    }
    if (part_by_flat_surface(cell, open) || halve(cell, open) || part_by_curved_surface(cell.cell))
      continue;
    finish(cell.cell);
  }
}

/// Takes all crushed zones out of the cells at them.
void Cutting::carve(CellPartition& partition) const {
  const std::vector<HoleCarving> zones = prisms();
  for (const ConvexCell& cell : at_holes_) {
    std::vector<ConvexCell> left{cell};
    for (const HoleCarving& zone : zones) {
      std::vector<ConvexCell> next;
      for (const ConvexCell& part : left) {
        const std::vector<ConvexCell> rock = zone.carve(
            part, [this](const ConvexCell& one) { return is_sliver(one); }, partition);
        next.insert(next.end(), rock.begin(), rock.end());
      }
      left = std::move(next);
    }
    for (ConvexCell& part : left) partition.finish(std::move(part), kRock);
  }
}

/// Rock too thin for a block goes with the void, thin voids with the rock: the prisms' size makes
/// up for both, so that a crushed zone has its volume.
void Cutting::fit_prisms() {
  constexpr int kRounds = 3;
  for (int round = 0; round < kRounds; ++round) {
    CellPartition trial = partition_;
    carve(trial);
    for (std::size_t h = 0; h < scales_.size(); ++h) {
      const double volume = trial.volume_filled_with(hole_face(static_cast<int>(h)));
      if (!(volume > 0.0)) continue;
      scales_[h] = std::clamp(scales_[h] * std::sqrt(cylinder_volumes_[h] / volume), 0.7, 1.2);
    }
  }
}

std::vector<Block> Cutting::run() {
  zones_ = prisms();
  for (const Hole& hole : rock_.holes) {
    beyond_walls_ = std::max(beyond_walls_, 0.5 * hole.radius);
    cylinder_volumes_.push_back(
        cylinder_volume_where(hole, [&](const Vec3& p) { return ground_.in_region(p); }));
  }
  for (ConvexCell& part : parts_between_planes()) refine(in_lattice(lattice_, std::move(part)));
  fit_prisms();
  carve(partition_);
  std::vector<Block> blocks = partition_.blocks();
  for (Block& block : blocks) block.target_size = ground_.size(block.mass.centroid);
  return blocks;
}

}  // namespace

Tessellation cut_by_joint_sets(const TessellationOptions& rock, const JointSetCut& how) {
  if (!(how.sliver >= 0.0 && how.sliver <= 0.3))
    refuse_joint_sets("sliver must be >= 0 and <= 0.3, got '", how.sliver, "'");
  Tessellation result;
  TessellationOptions without_rings = rock;
  without_rings.rings = false;
  result.statistics.expected_blocks = checked_block_count(without_rings);
  Cutting cutting(rock, how);
  result.blocks = cutting.run();
  if (result.blocks.empty()) refuse_joint_sets("the rock holds no block");
  result.statistics.cylinder_volume = cutting.cylinder_volumes();
  result.statistics.merged_parts = cutting.merged_parts();
  add_statistics(rock, result);
  return result;
}

}  // namespace muckpile
