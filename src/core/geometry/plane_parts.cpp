// SPDX-License-Identifier: GPL-2.0-or-later
// Rock that planes cut through and through: its parts, and how they are joined again.
// Scope: see the header.
#include "geometry/plane_parts.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "geometry/ground.h"
#include "geometry/seeding.h"
#include "geometry/shared_faces.h"

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

bool differ_in_one(const Sides& a, const Sides& b) {
  int different = 0;
  for (std::size_t k = 0; k < a.size(); ++k) different += a[k] != b[k] ? 1 : 0;
  return different == 1;
}

Vec3 mirrored(const CutPlane& plane, const Vec3& p) {
  return p - 2.0 * height(plane, p) * plane.normal.normalized();
}

/// Replaces the layer of seeds below the plane by the images of the one above it.
void mirror_layer(const CutPlane& plane, const std::vector<CutPlane>& planes, const Ground& ground,
                  std::vector<Vec3>& seeds) {
  constexpr double kLayer = 1.5;  // blocks: the ones at the plane, and those that show between them
  const auto in_layer = [&](const Vec3& p) {
    return std::abs(height(plane, p)) < kLayer * ground.size(p);
  };
  std::vector<Vec3> images;
  for (const Vec3& seed : seeds) {
    if (height(plane, seed) <= 0.0 || !in_layer(seed)) continue;
    const Vec3 image = mirrored(plane, seed);
    if (ground.is_rock(image) && differ_in_one(sides_of(planes, seed), sides_of(planes, image)))
      images.push_back(image);
  }
  std::erase_if(seeds, [&](const Vec3& p) { return height(plane, p) <= 0.0 && in_layer(p); });
  seeds.insert(seeds.end(), images.begin(), images.end());
}

}  // namespace

Sides sides_of(const std::vector<CutPlane>& planes, const Vec3& point) {
  Sides sides;
  for (const CutPlane& plane : planes) sides.push_back(height(plane, point) > 0.0);
  return sides;
}

std::vector<RockPart> parts_of(const TessellationOptions& options) {
  constexpr unsigned long kLooks = 8;
  std::map<Sides, std::vector<Vec3>> found;
  const Ground ground(options);
  std::vector<Vec3> seeds = scatter_seeds(options, ground);
  for (const CutPlane& plane : options.planes) mirror_layer(plane, options.planes, ground, seeds);
  for (const Vec3& seed : seeds) found[sides_of(options.planes, seed)].push_back(seed);
  TessellationOptions again = options;
  for (unsigned long k = 1; k <= kLooks; ++k) {
    again.seed = options.seed + k;
    for (const Vec3& point : scatter_seeds(again, ground))
      found.try_emplace(sides_of(options.planes, point), 1, point);
  }
  std::vector<RockPart> parts;
  for (auto& [sides, own] : found) parts.push_back({sides, std::move(own)});
  return parts;
}

std::vector<SeedPair> pairs_across(const TessellationOptions& options,
                                   const std::vector<RockPart>& parts) {
  constexpr double kRounding = 1e-6;  // of the block size
  const Ground ground(options);
  std::vector<SeedPair> pairs;
  for (std::size_t k = 0; k < options.planes.size(); ++k) {
    for (std::size_t a = 0; a < parts.size(); ++a) {
      if (!parts[a].sides[k]) continue;
      Sides behind = parts[a].sides;
      behind[k] = false;
      const auto other = std::find_if(parts.begin(), parts.end(),
                                      [&](const RockPart& p) { return p.sides == behind; });
      if (other == parts.end()) continue;
      const auto b = static_cast<std::size_t>(other - parts.begin());
      for (std::size_t i = 0; i < parts[a].seeds.size(); ++i) {
        const Vec3 image = mirrored(options.planes[k], parts[a].seeds[i]);
        const double near = kRounding * ground.size(image);
        const auto twin =
            std::find_if(other->seeds.begin(), other->seeds.end(),
                         [&](const Vec3& seed) { return (seed - image).norm() < near; });
        if (twin == other->seeds.end()) continue;
        pairs.push_back({k, a, i, b, static_cast<std::size_t>(twin - other->seeds.begin())});
      }
    }
  }
  return pairs;
}

void make_symmetric(const std::vector<CutPlane>& planes, const SeedPair& pair, Vec3& seed,
                    Vec3& other) {
  const CutPlane& plane = planes[pair.plane];
  seed = 0.5 * (seed + mirrored(plane, other));
  other = mirrored(plane, seed);
}

TessellationOptions options_of(const TessellationOptions& options, const Sides& sides) {
  TessellationOptions part = options;
  part.planes.clear();
  const std::vector<CutPlane> planes = options.planes;
  const RegionQuery whole = options.region;
  part.region.inside = [=](const Vec3& p) {
    return (!whole.inside || whole.inside(p)) && sides_of(planes, p) == sides;
  };
  constexpr double kReach = 2.0;  // further than at other surfaces: images there never hurt
  part.region.surface_points = [=](const Vec3& p, double cutoff) {
    std::vector<Vec3> points;
    if (whole.surface_points) points = whole.surface_points(p, cutoff);
    for (const CutPlane& plane : planes) {
      const double away = height(plane, p);
      if (std::abs(away) < kReach * cutoff) points.push_back(p - away * plane.normal.normalized());
    }
    return points;
  };
  return part;
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
