// SPDX-License-Identifier: GPL-2.0-or-later
// Takes the crushed zone of a charge out of convex cells.
// Scope: see the header.
#include "geometry/holes/hole_carving.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace muckpile {
namespace {

int side_count(double radius, double wall_size) {
  constexpr int kFewest = 6, kMost = 32;  // below six the prism is no cylinder
  const int even = 2 * static_cast<int>(std::lround(std::numbers::pi * radius / wall_size));
  return std::clamp(even, kFewest, kMost);
}

}  // namespace

HoleCarving::HoleCarving(const Hole& hole, int number, double wall_size, double scale)
    : hole_(hole), axis_(hole.toe, hole.collar), code_(hole_face(number)) {
  const int count = side_count(hole.radius, wall_size);
  const double pi = std::numbers::pi;
  // A polygon of n sides at distance d from the middle has the area n d^2 tan(pi/n).
  const double distance = scale * hole.radius * std::sqrt(pi / (count * std::tan(pi / count)));
  const Vec3 along = (hole.collar - hole.toe).normalized();
  const Vec3 first = along.unitOrthogonal(), second = along.cross(first);
  for (int k = 0; k < count; ++k) {
    const double angle = 2.0 * pi * (k + 0.5) / count;
    const Vec3 normal = std::cos(angle) * first + std::sin(angle) * second;
    sides_.push_back({hole.toe + distance * normal, normal});
  }
  ends_ = {{hole.toe, -along}, {hole.collar, along}};
}

bool HoleCarving::near(const ConvexCell& cell) const {
  const Vec3 centroid = centroid_of(cell);
  double reach = 0.0;
  for (const Vec3& v : cell.shape.vertices) reach = std::max(reach, (v - centroid).norm());
  constexpr double kEdges = 1.5;  // the prism's edges stick out of the cylinder
  return axis_.distance(centroid) < reach + kEdges * hole_.radius;
}

std::optional<HoleCarving::Inside> HoleCarving::part_inside(const ConvexCell& cell) const {
  if (!near(cell)) return std::nullopt;
  constexpr int kFirst = -1000;  // numbers that no box wall and no plane has
  Inside inside{cell, {}};
  for (std::size_t k = 0; k < sides_.size() + ends_.size(); ++k) {
    const CutPlane& plane = k < sides_.size() ? sides_[k] : ends_[k - sides_.size()];
    auto part = part_below(inside.cell, plane.point, plane.normal, kFirst - static_cast<int>(k));
    if (!part) return std::nullopt;
    inside.cell = std::move(*part);
  }
  for (std::size_t k = 0; k < sides_.size(); ++k) {
    const auto& made_by = inside.cell.made_by;
    if (std::find(made_by.begin(), made_by.end(), kFirst - static_cast<int>(k)) != made_by.end())
      inside.sides.push_back(k);
  }
  return inside;
}

HoleCarving::Place HoleCarving::place_of(const ConvexCell& cell) const {
  constexpr double kAll = 1.0 - 1e-9;
  const auto inside = part_inside(cell);
  if (!inside) return Place::outside;
  return volume_of(inside->cell) > kAll * volume_of(cell) ? Place::inside : Place::across;
}

HoleCarving::Rock HoleCarving::rock_of(const ConvexCell& cell) const {
  const MassProperties whole = mass_properties(cell.shape);
  const auto inside = part_inside(cell);
  if (!inside) return {whole.volume, whole.centroid, 1};
  const MassProperties gone = mass_properties(inside->cell.shape);
  const double left = whole.volume - gone.volume;
  if (left < 1e-9 * whole.volume) return {0.0, whole.centroid, 1};
  return {left, (whole.volume * whole.centroid - gone.volume * gone.centroid) / left,
          std::max<std::size_t>(1, inside->sides.size())};
}

CutPlane HoleCarving::radius_between(std::size_t side, std::size_t next) const {
  const Vec3 along = ends_[1].normal;
  const Vec3 edge = sides_[side].normal + sides_[next].normal;
  return {hole_.toe, along.cross(edge).normalized()};
}

/// Divides along the first radius that leaves no thin part.
std::optional<HalfCells> HoleCarving::part_by_radius(const ConvexCell& cell,
                                                     const std::vector<std::size_t>& sides,
                                                     const Thin& thin,
                                                     CellPartition& partition) const {
  for (const std::size_t side : sides) {
    const std::size_t next = (side + 1) % sides_.size();
    if (std::find(sides.begin(), sides.end(), next) == sides.end()) continue;
    auto halves = partition.divide(cell, radius_between(side, next));
    if (halves && !thin(halves->below) && !thin(halves->above)) return halves;
  }
  return std::nullopt;
}

bool HoleCarving::is_mostly_rock(const ConvexCell& cell) const {
  const auto inside = part_inside(cell);
  return !inside || volume_of(inside->cell) < 0.5 * volume_of(cell);
}

/// Divides by the side that leaves most rock, then by the others. What no side divides is void or
/// rock, whichever is the larger part of it.
void HoleCarving::carve_sides(ConvexCell cell, const std::vector<std::size_t>& sides,
                              const Thin& thin, CellPartition& partition,
                              std::vector<ConvexCell>& rock) const {
  while (true) {
    double most = 0.0;
    std::optional<CutPlane> best;
    for (const std::size_t side : sides) {
      const auto halves = divided(cell, sides_[side].point, sides_[side].normal, 0);
      if (!halves || thin(halves->above)) continue;
      const double left = volume_of(halves->above);
      if (left > most) best = sides_[side];
      most = std::max(most, left);
    }
    if (!best) break;
    auto halves = partition.divide(cell, *best);
    if (thin(halves->below) && is_mostly_rock(halves->below)) break;
    rock.push_back(std::move(halves->above));
    cell = std::move(halves->below);
  }
  if (is_mostly_rock(cell)) return rock.push_back(std::move(cell));
  partition.finish(std::move(cell), code_);
}

void HoleCarving::carve_part(const ConvexCell& cell, const Thin& thin, CellPartition& partition,
                             std::vector<ConvexCell>& rock) const {
  const auto inside = part_inside(cell);
  if (!inside || thin(inside->cell)) return rock.push_back(cell);
  for (const CutPlane& end : ends_) {
    auto halves = partition.divide(cell, end);
    if (!halves || thin(halves->above)) continue;
    if (thin(halves->below)) return rock.push_back(cell);
    rock.push_back(std::move(halves->above));
    return carve_part(halves->below, thin, partition, rock);
  }
  if (inside->sides.size() > 1) {
    if (const auto halves = part_by_radius(cell, inside->sides, thin, partition)) {
      carve_part(halves->below, thin, partition, rock);
      return carve_part(halves->above, thin, partition, rock);
    }
  }
  carve_sides(cell, inside->sides, thin, partition, rock);
}

std::vector<ConvexCell> HoleCarving::carve(const ConvexCell& cell, const Thin& thin,
                                           CellPartition& partition) const {
  std::vector<ConvexCell> rock;
  carve_part(cell, thin, partition, rock);
  return rock;
}

}  // namespace muckpile
