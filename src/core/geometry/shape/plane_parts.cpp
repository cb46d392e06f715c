// SPDX-License-Identifier: GPL-2.0-or-later
// Rock that planes cut through and through: its parts, and how they are joined again.
// Scope: see the header.
#include "geometry/shape/plane_parts.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/cut/seeding.h"
#include "geometry/cut/shared_faces.h"
#include "geometry/index/point_index.h"

namespace muckpile {
namespace {

double height(const CutPlane& plane, const Vec3& point) {
  return plane.normal.normalized().dot(point - plane.point);
}

/// Faces in the plane of blocks below (`side` 1) or above it (-1).
std::vector<PlaneFace> faces_in(const PlaneFrame& frame, const std::vector<Block>& blocks,
                                double side) {
  constexpr double kRounding = 1e-7;  // of the block size, and radians
  std::vector<PlaneFace> found;
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const Block& block = blocks[b];
    for (std::size_t f = 0; f < block.neighbour.size(); ++f) {
      if (block.neighbour[f] != kFreeFace) continue;
      const FaceGeometry face = face_geometry(block.shape, static_cast<int>(f));
      const double off = frame.normal.dot(face.centroid - frame.origin);
      if (std::abs(off) > kRounding * std::cbrt(block.mass.volume)) continue;
      if ((face.normal - side * frame.normal).norm() > kRounding) continue;
      found.push_back(plane_face(frame, blocks, b, f, side));
    }
  }
  return found;
}

/// Which side of each plane a point is on.
std::vector<bool> sides_of(const std::vector<CutPlane>& planes, const Vec3& point) {
  std::vector<bool> sides;
  for (const CutPlane& plane : planes) sides.push_back(height(plane, point) > 0.0);
  return sides;
}

Vec3 mirrored(const CutPlane& plane, const Vec3& p) {
  return p - 2.0 * height(plane, p) * plane.normal.normalized();
}

bool is_within(const std::vector<CutPlane>& bounds, const Vec3& point) {
  return std::all_of(bounds.begin(), bounds.end(),
                     [&](const CutPlane& bound) { return height(bound, point) <= 0.0; });
}

/// Whether the image of a point is rock just behind this plane and no other.
bool has_image(const TessellationOptions& options, const Ground& ground, std::size_t plane,
               const Vec3& p) {
  const Vec3 image = mirrored(options.planes[plane], p);
  if (!ground.is_rock(image)) return false;
  const std::vector<bool> here = sides_of(options.planes, p),
                          there = sides_of(options.planes, image);
  for (std::size_t k = 0; k < here.size(); ++k) {
    if ((here[k] != there[k]) != (k == plane)) return false;
  }
  return true;
}

/// Replaces the layer of seeds below the plane by the images of the one above it.
void mirror_layer(const TessellationOptions& options, const Ground& ground, std::size_t number,
                  std::vector<Vec3>& seeds) {
  constexpr double kLayer = 1.5;  // blocks: the ones at the plane, and those that show between them
  const CutPlane& plane = options.planes[number];
  const auto in_layer = [&](const Vec3& p) {
    return std::abs(height(plane, p)) < kLayer * ground.size(p);
  };
  std::vector<Vec3> images;
  for (const Vec3& seed : seeds) {
    if (height(plane, seed) > 0.0 && in_layer(seed) && has_image(options, ground, number, seed))
      images.push_back(mirrored(plane, seed));
  }
  std::erase_if(seeds, [&](const Vec3& p) {
    return height(plane, p) <= 0.0 && in_layer(mirrored(plane, p)) &&
           has_image(options, ground, number, p);
  });
  seeds.insert(seeds.end(), images.begin(), images.end());
}

struct BoundedCell {
  ConvexCell cell;
  std::vector<CutPlane> bounds;
};

std::vector<BoundedCell> cells_between(const TessellationOptions& options, const Ground& ground,
                                       std::size_t& merged) {
  std::vector<BoundedCell> cells{{box_cell(options.lo, options.hi), {}}};
  for (const CutPlane& plane : options.planes) {
    const Vec3 normal = plane.normal.normalized();
    std::vector<BoundedCell> next;
    for (BoundedCell& whole : cells) {
      auto halves = divided(whole.cell, plane.point, normal, 0);
      const bool thin = halves && cuts_sliver_off(*halves, ground, kThinnestPart);
      merged += thin ? 1 : 0;
      if (!halves || thin) {
        next.push_back(std::move(whole));
        continue;
      }
      next.push_back({std::move(halves->below), whole.bounds});
      next.back().bounds.push_back({plane.point, normal});
      next.push_back({std::move(halves->above), std::move(whole.bounds)});
      next.back().bounds.push_back({plane.point, -normal});
    }
    cells = std::move(next);
  }
  return cells;
}

/// Rock in a part, by counting points of a grid around it [m3].
double rock_volume(const Ground& ground, const BoundedCell& part) {
  constexpr int kPoints = 16;  // per axis
  Vec3 lo = part.cell.shape.vertices.front(), hi = lo;
  for (const Vec3& v : part.cell.shape.vertices) {
    lo = lo.cwiseMin(v);
    hi = hi.cwiseMax(v);
  }
  const Vec3 step = (hi - lo) / kPoints;
  int hits = 0;
  for (int k = 0; k < kPoints * kPoints * kPoints; ++k) {
    const Vec3 place(k % kPoints + 0.5, k / kPoints % kPoints + 0.5, k / (kPoints * kPoints) + 0.5);
    const Vec3 point = lo + place.cwiseProduct(step);
    hits += is_within(part.bounds, point) && ground.is_rock(point) ? 1 : 0;
  }
  return hits * step.prod();
}

/// A place in the rock of a part that no seed fell into: its middle, or a random one.
std::vector<Vec3> any_seed(const TessellationOptions& options, const Ground& ground,
                           const BoundedCell& part) {
  constexpr unsigned long kLooks = 8;
  const Vec3 middle = centroid_of(part.cell);
  if (ground.is_rock(middle)) return {middle};
  TessellationOptions again = options;
  for (unsigned long k = 1; k <= kLooks; ++k) {
    again.seed = options.seed + k;
    for (const Vec3& point : scatter_seeds(again, ground))
      if (is_within(part.bounds, point)) return {point};
  }
  return {};
}

}  // namespace

bool cuts_sliver_off(const HalfCells& halves, const Ground& ground, double thinnest) {
  const auto is_sliver = [&](const ConvexCell& half) {
    return mean_radius(half.shape) < thinnest * ground.size(centroid_of(half));
  };
  return is_sliver(halves.below) || is_sliver(halves.above);
}

RockParts parts_of(const TessellationOptions& options) {
  const Ground ground(options);
  std::vector<Vec3> seeds = scatter_seeds(options, ground);
  for (std::size_t k = 0; k < options.planes.size(); ++k) mirror_layer(options, ground, k, seeds);
  RockParts found;
  for (const BoundedCell& cell : cells_between(options, ground, found.merged)) {
    RockPart part{cell.bounds, {}};
    const auto others = std::stable_partition(
        seeds.begin(), seeds.end(), [&](const Vec3& p) { return is_within(part.bounds, p); });
    part.seeds.assign(seeds.begin(), others);
    seeds.erase(seeds.begin(), others);
    if (part.seeds.empty()) part.seeds = any_seed(options, ground, cell);
    if (part.seeds.empty()) {
      const double rock = rock_volume(ground, cell);
      found.lost += rock > 0.0 ? 1 : 0;
      found.lost_volume += rock;
    } else {
      found.parts.push_back(std::move(part));
    }
  }
  return found;
}

std::vector<SeedPair> pairs_across(const TessellationOptions& options,
                                   const std::vector<RockPart>& parts) {
  constexpr double kRounding = 1e-6;  // of the block size
  const Ground ground(options);
  std::vector<Vec3> all;
  std::vector<std::pair<std::size_t, std::size_t>> place;  // part, seed
  for (std::size_t p = 0; p < parts.size(); ++p) {
    for (std::size_t i = 0; i < parts[p].seeds.size(); ++i) {
      all.push_back(parts[p].seeds[i]);
      place.emplace_back(p, i);
    }
  }
  const PointIndex index(all);
  PointIndex::Found twins;
  std::vector<SeedPair> pairs;
  for (std::size_t k = 0; k < options.planes.size(); ++k) {
    for (std::size_t n = 0; n < all.size(); ++n) {
      if (height(options.planes[k], all[n]) <= 0.0) continue;
      const Vec3 image = mirrored(options.planes[k], all[n]);
      index.shell(image, 0.0, kRounding * ground.size(image), twins);
      if (twins.empty()) continue;
      const auto [part, seed] = place[n];
      const auto [other, twin] = place[static_cast<std::size_t>(twins.front().second)];
      if (part != other) pairs.push_back({k, part, seed, other, twin});
    }
  }
  return pairs;
}

void make_symmetric(const CutPlane& plane, const RockPart& part, Vec3& seed,
                    const RockPart& other_part, Vec3& other) {
  const Vec3 mean = 0.5 * (seed + mirrored(plane, other)), image = mirrored(plane, mean);
  if (!is_within(part.bounds, mean) || !is_within(other_part.bounds, image)) return;
  seed = mean;
  other = image;
}

TessellationOptions options_of(const TessellationOptions& options, const RockPart& part) {
  TessellationOptions alone = options;
  alone.planes.clear();
  const RegionQuery whole = options.region;
  alone.region.inside = [whole, bounds = part.bounds](const Vec3& p) {
    return (!whole.inside || whole.inside(p)) && is_within(bounds, p);
  };
  if (!whole.surface_points)
    alone.region.surface_points = [](const Vec3&, double) { return std::vector<Vec3>{}; };
  return alone;
}

void join_in_planes(const std::vector<CutPlane>& planes, std::vector<Block>& blocks) {
  for (const CutPlane& plane : planes) {
    const PlaneFrame frame(plane.point, plane.normal);
    std::vector<PlaneFace> below = faces_in(frame, blocks, 1.0),
                           above = faces_in(frame, blocks, -1.0);
    Pieces pieces;
    share_faces(frame, below, above, pieces);
    divide_faces(pieces, blocks);
  }
}

}  // namespace muckpile
