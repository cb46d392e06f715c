// SPDX-License-Identifier: GPL-2.0-or-later
// Rock that planes cut through and through: its parts and their seeds.
// Scope: see the header.
#include "geometry/shape/plane_parts.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/cut/seeding.h"
#include "geometry/holes/hole_surface.h"
#include "geometry/index/point_index.h"
#include "geometry/size/size_factor.h"

namespace muckpile {
namespace {

constexpr double kLayer = 1.5;  // blocks: the ones at a plane, and those that show between them

// Normals of planes have length 1 in all of this file.
double height(const CutPlane& plane, const Vec3& point) {
  return plane.normal.dot(point - plane.point);
}

std::vector<CutPlane> with_unit_normals(std::vector<CutPlane> planes) {
  for (CutPlane& plane : planes) plane.normal.normalize();
  return planes;
}

Vec3 mirrored(const CutPlane& plane, const Vec3& p) {
  return p - 2.0 * height(plane, p) * plane.normal;
}

bool is_within(const std::vector<CutPlane>& bounds, const Vec3& point) {
  return std::all_of(bounds.begin(), bounds.end(),
                     [&](const CutPlane& bound) { return height(bound, point) <= 0.0; });
}

/// Whether the image of a point is rock just behind this plane and no other.
bool has_image(const std::vector<CutPlane>& planes, const Ground& ground, std::size_t plane,
               const Vec3& p) {
  const Vec3 image = mirrored(planes[plane], p);
  if (!ground.is_rock(image)) return false;
  for (std::size_t k = 0; k < planes.size(); ++k) {
    const bool parted = (height(planes[k], p) > 0.0) != (height(planes[k], image) > 0.0);
    if (parted != (k == plane)) return false;
  }
  return true;
}

/// Makes mirror pairs of the seeds in a layer at the plane, whichever side its normal looks to:
/// those of the side with the smaller blocks, and their images, thinned evenly to as many as the
/// sizes on both sides ask for together. No block is wider than `largest` [m].
void mirror_layer(const std::vector<CutPlane>& planes, const Ground& ground, double largest,
                  std::size_t number, std::vector<Vec3>& seeds) {
  constexpr double kTie = 1e-6;  // of a size [-]: rounding does not decide whose seeds count
  const CutPlane& plane = planes[number];
  std::vector<Vec3> kept, images;
  double asked = 0.5;  // pairs so far; one is made whenever a whole number is passed
  for (const Vec3& seed : seeds) {
    const Vec3 image = mirrored(plane, seed);
    const double away = std::abs(height(plane, seed)), here = ground.size(seed),
                 there = ground.size(image);
    // As deep as the smaller blocks ask for: else blocks at a charge would depend on what lies
    // behind a plane.
    const bool in_layer = away < kLayer * std::min({largest, here, there});
    if (!in_layer || !has_image(planes, ground, number, seed)) {
      kept.push_back(seed);
      continue;
    }
    const bool above = height(plane, seed) > 0.0;
    const bool counts = above ? here <= (1.0 + kTie) * there : there > (1.0 + kTie) * here;
    if (!counts) continue;
    const double before = std::floor(asked);
    asked += 0.5 * (1.0 + std::min(1.0, std::pow(here / there, 3)));  // blocks per volume
    if (std::floor(asked) == before) continue;
    kept.push_back(seed);
    images.push_back(image);
  }
  seeds = std::move(kept);
  seeds.insert(seeds.end(), images.begin(), images.end());
}

/// A part as it is divided: its faces know which plane made them, and its seeds go with it.
struct SeededCell {
  ConvexCell cell;
  std::vector<Vec3> seeds;
};

/// The seeds on the two sides of a plane, in their order; those in it are below.
std::pair<std::vector<Vec3>, std::vector<Vec3>> parted(const CutPlane& plane,
                                                       const std::vector<Vec3>& seeds) {
  std::pair<std::vector<Vec3>, std::vector<Vec3>> sides;
  for (const Vec3& seed : seeds)
    (height(plane, seed) <= 0.0 ? sides.first : sides.second).push_back(seed);
  return sides;
}

std::vector<SeededCell> cells_between(const TessellationOptions& options,
                                      const std::vector<CutPlane>& planes, const Ground& ground,
                                      std::vector<Vec3> seeds, std::size_t& merged) {
  std::vector<SeededCell> cells{{box_cell(options.lo, options.hi), std::move(seeds)}};
  for (std::size_t k = 0; k < planes.size(); ++k) {
    std::vector<SeededCell> next;
    for (SeededCell& whole : cells) {
      auto halves = divided(whole.cell, planes[k].point, planes[k].normal, static_cast<int>(k));
      const bool thin = halves && cuts_sliver_off(*halves, ground, kThinnestPart);
      merged += thin ? 1 : 0;
      if (!halves || thin) {
        next.push_back(std::move(whole));
        continue;
      }
      auto [below, above] = parted(planes[k], whole.seeds);
      next.push_back({std::move(halves->below), std::move(below)});
      next.push_back({std::move(halves->above), std::move(above)});
    }
    cells = std::move(next);
  }
  return cells;
}

/// The planes that made the cell's faces, looking out.
std::vector<CutPlane> bounds_of(const ConvexCell& cell, const std::vector<CutPlane>& planes) {
  const Vec3 middle = centroid_of(cell);
  std::vector<CutPlane> bounds;
  for (const int number : cell.made_by) {
    if (number < 0) continue;
    const CutPlane& plane = planes[static_cast<std::size_t>(number)];
    const double out = height(plane, middle) <= 0.0 ? 1.0 : -1.0;
    bounds.push_back({plane.point, out * plane.normal});
  }
  return bounds;
}

bool in_a_hole(const TessellationOptions& options, const Vec3& point) {
  return std::any_of(options.holes.begin(), options.holes.end(),
                     [&](const Hole& hole) { return inside_hole(hole, point); });
}

/// Rock in a part, by counting points of a grid around it [m3].
double rock_volume(const TessellationOptions& options, const Ground& ground, const ConvexCell& cell,
                   const std::vector<CutPlane>& bounds) {
  constexpr int kPoints = 16;  // per axis
  Vec3 lo = cell.shape.vertices.front(), hi = lo;
  for (const Vec3& v : cell.shape.vertices) {
    lo = lo.cwiseMin(v);
    hi = hi.cwiseMax(v);
  }
  const Vec3 step = (hi - lo) / kPoints;
  int hits = 0;
  for (int k = 0; k < kPoints * kPoints * kPoints; ++k) {
    const Vec3 place(k % kPoints + 0.5, k / kPoints % kPoints + 0.5, k / (kPoints * kPoints) + 0.5);
    const Vec3 point = lo + place.cwiseProduct(step);
    hits +=
        is_within(bounds, point) && ground.in_region(point) && !in_a_hole(options, point) ? 1 : 0;
  }
  return hits * step.prod();
}

/// Looks for places in the rock of parts that no seed fell into: the first of other random seeds,
/// which are made once for all parts.
class FurtherSeeds {
 public:
  FurtherSeeds(const TessellationOptions& options, const Ground& ground)
      : options_(options), ground_(ground) {}

  [[nodiscard]] std::vector<Vec3> in(const std::vector<CutPlane>& bounds) {
    for (unsigned long k = 1; k <= kLooks; ++k) {
      for (const Vec3& point : scattered(k))
        if (is_within(bounds, point)) return {point};
    }
    return {};
  }

 private:
  static constexpr unsigned long kLooks = 8;

  const std::vector<Vec3>& scattered(unsigned long k) {
    if (scattered_.size() < k) {
      TessellationOptions again = options_;
      again.seed = options_.seed + k;
      scattered_.push_back(scatter_seeds(again, ground_));
    }
    return scattered_[k - 1];
  }

  const TessellationOptions& options_;
  const Ground& ground_;
  std::vector<std::vector<Vec3>> scattered_;
};

}  // namespace

bool cuts_sliver_off(const HalfCells& halves, const Ground& ground, double thinnest) {
  const auto is_sliver = [&](const ConvexCell& half) {
    return mean_radius(half.shape) < thinnest * ground.size(centroid_of(half));
  };
  return is_sliver(halves.below) || is_sliver(halves.above);
}

RockParts parts_of(const TessellationOptions& options) {
  const Ground ground = voronoi_ground(options);
  const std::vector<CutPlane> planes = with_unit_normals(options.planes);
  const double largest = largest_block(options);
  std::vector<Vec3> seeds = scatter_seeds(options, ground);
  for (std::size_t k = 0; k < planes.size(); ++k) mirror_layer(planes, ground, largest, k, seeds);
  const HoleRings rings(options);
  RockParts found;
  FurtherSeeds further(options, ground);
  for (SeededCell& cell : cells_between(options, planes, ground, std::move(seeds), found.merged)) {
    RockPart part{bounds_of(cell.cell, planes), std::move(cell.seeds)};
    const Vec3 middle = centroid_of(cell.cell);
    if (part.seeds.empty() && ground.is_rock(middle)) part.seeds = {middle};
    if (part.seeds.empty() && rings_in(rings, part).seeds().empty()) {
      const double rock = rock_volume(options, ground, cell.cell, part.bounds);
      if (rock > 0.0) part.seeds = further.in(part.bounds);
      if (part.seeds.empty()) {
        found.lost += rock > 0.0 ? 1 : 0;
        found.lost_volume += rock;
        continue;
      }
    }
    found.parts.push_back(std::move(part));
  }
  return found;
}

HoleRings rings_in(const HoleRings& rings, const RockPart& part) {
  return rings.within(part.bounds, part.seeds.empty());
}

std::vector<SeedPair> pairs_across(const TessellationOptions& options,
                                   const std::vector<RockPart>& parts) {
  constexpr double kRounding = 1e-6;  // of the block size
  const Ground ground = voronoi_ground(options);
  const std::vector<CutPlane> planes = with_unit_normals(options.planes);
  const double farthest = kLayer * largest_block(options);
  std::vector<Vec3> all;
  std::vector<std::pair<std::size_t, std::size_t>> place;  // part, seed
  for (std::size_t p = 0; p < parts.size(); ++p) {
    for (std::size_t i = 0; i < parts[p].seeds.size(); ++i) {
      all.push_back(parts[p].seeds[i]);
      place.emplace_back(p, i);
    }
  }
  const PointIndex index(all);
  PointSearch search(index);
  std::vector<SeedPair> pairs;
  for (std::size_t k = 0; k < planes.size(); ++k) {
    for (std::size_t n = 0; n < all.size(); ++n) {
      const double above = height(planes[k], all[n]);
      if (above <= 0.0 || above > farthest) continue;
      const Vec3 image = mirrored(planes[k], all[n]);
      const PointSearch::Found& twins = search.shell(image, 0.0, kRounding * ground.size(image));
      if (twins.empty()) continue;
      const auto [part, seed] = place[n];
      const auto [other, twin] = place[static_cast<std::size_t>(twins.front().second)];
      if (part != other) pairs.push_back({k, part, seed, other, twin});
    }
  }
  return pairs;
}

void make_symmetric(const Ground& ground, const CutPlane& across, const RockPart& part, Vec3& seed,
                    const RockPart& other_part, Vec3& other) {
  const CutPlane plane{across.point, across.normal.normalized()};
  const Vec3 mean = 0.5 * (seed + mirrored(plane, other)), image = mirrored(plane, mean);
  if (!is_within(part.bounds, mean) || !is_within(other_part.bounds, image)) return;
  if (!ground.is_rock(mean) || !ground.is_rock(image)) return;
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

}  // namespace muckpile
