// SPDX-License-Identifier: GPL-2.0-or-later
// Cells parted by surfaces from files.
// Scope: see the header.
#include "geometry/cut/fitted_cutting.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/cut/region_cutting.h"
#include "geometry/shape/face_samples.h"

namespace muckpile {
namespace {

constexpr double kNearest = 0.05;  // [block sizes] from the point in the rock to a plane
constexpr int kTrial = std::numeric_limits<int>::max();  // number of a plane that is tried

std::size_t face_made_by(const ConvexCell& cell, int number) {
  return static_cast<std::size_t>(std::ranges::find(cell.made_by, number) - cell.made_by.begin());
}

/// The middle of those lookouts that are in the rock, or the one next to it; none without any.
std::optional<Vec3> point_in_rock(const RegionQuery& region, const ConvexCell& cell) {
  std::vector<Vec3> inside = lookouts(cell, centroid_of(cell));
  std::erase_if(inside, [&](const Vec3& p) { return !region.inside(p); });
  if (inside.empty()) return std::nullopt;
  Vec3 mean = Vec3::Zero();
  for (const Vec3& p : inside) mean += p / static_cast<double>(inside.size());
  if (region.inside(mean)) return mean;
  return *std::ranges::min_element(inside, {}, [&](const Vec3& p) { return (p - mean).norm(); });
}

/// Walls cut the rock of a cell out of it, and move until each lies on its surface in the mean of
/// the face that it makes, as those of a Voronoi cut do.
class Parting {
 public:
  Parting(const ConvexCell& cell, const Vec3& in_rock, double size)
      : whole_(cell), from_(in_rock), size_(size) {}

  void add(const CutPlane& plane, const FittedSurface& surface) {
    walls_.push_back({plane, &surface, false});
    keep_off(walls_.back().plane);
  }

  FittedPart fitted(const std::vector<const FittedSurface*>& surfaces) {
    constexpr int kRounds = 3;
    for (int round = 0; round < kRounds; ++round) {
      cut();
      for (const FittedSurface* surface : surfaces) stop_leak(*surface);
      cut();
      for (Wall& wall : walls_) fit(wall);
    }
    cut();
    FittedPart part{true, left_, {}};
    for (const Wall& wall : walls_)
      if (wall.cuts) part.planes.push_back(wall.plane);
    return part;
  }

 private:
  struct Wall {
    CutPlane plane;
    const FittedSurface* surface;
    bool cuts;  // at its present place
  };

  void cut() {
    left_ = whole_;
    for (std::size_t w = 0; w < walls_.size(); ++w) {
      const auto halves =
          divided(left_, walls_[w].plane.point, walls_[w].plane.normal, number_of(w));
      walls_[w].cuts = halves && !is_film(halves->below, size_) && !is_film(halves->above, size_);
      if (walls_[w].cuts) left_ = halves->below;
    }
  }

  void fit(Wall& wall) const {
    constexpr double kMost = 0.25;  // [block sizes] of a step
    const std::size_t face =
        face_made_by(left_, number_of(static_cast<std::size_t>(&wall - walls_.data())));
    if (!wall.cuts || face == left_.made_by.size()) return;
    const double off = mean_over_face(left_.shape, face, wall.surface->height);
    wall.plane.point -= std::clamp(off, -kMost * size_, kMost * size_) * wall.plane.normal;
    keep_off(wall.plane);
  }

  /// Where a corner sticks out by a quarter block, one more wall at the surface below it.
  void stop_leak(const FittedSurface& surface) {
    constexpr double kMost = 0.25;  // [block sizes]
    const auto highest = std::ranges::max_element(left_.shape.vertices, {}, surface.height);
    if (surface.height(*highest) < kMost * size_) return;
    const Vec3 at = surface.closest(*highest);
    add({at, (*highest - at).normalized()}, surface);
  }

  void keep_off(CutPlane& plane) const {
    const double away = plane.normal.dot(plane.point - from_);
    plane.point += std::max(0.0, kNearest * size_ - away) * plane.normal;
  }

  static int number_of(std::size_t wall) { return kTrial - static_cast<int>(wall); }

  ConvexCell whole_, left_{};
  std::vector<Wall> walls_{};
  Vec3 from_;
  double size_;
};

/// What of the plane lies in the cell is somewhere on the surface, and else in the air.
bool bounds_rock_only(const FittedSurface& surface, const ConvexCell& half, double reach) {
  constexpr double kOn = 1e-4, kLeast = 0.3;  // [reach], share of the area
  double on = 0.0, all = 0.0;
  bool in_rock = false;
  sample_face(half.shape, face_made_by(half, kTrial), [&](const Vec3& at, double area) {
    if (in_rock) return;
    const double height = surface.height(at);
    in_rock = height < -kOn * reach;
    on += std::abs(height) <= kOn * reach ? area : 0.0;
    all += area;
  });
  return !in_rock && on >= kLeast * all;
}

}  // namespace

bool is_film(const ConvexCell& cell, double size) {
  constexpr double kThinnest = 0.01;
  return mean_radius(cell.shape) < kThinnest * size;
}

bool is_near_fitted(const RegionQuery& region, const ConvexCell& cell) {
  const Vec3 middle = centroid_of(cell);
  const double reach = reach_of(cell, middle);
  return std::ranges::any_of(region.fitted, [&](const FittedSurface& surface) {
    return (surface.closest(middle) - middle).norm() <= reach;
  });
}

FittedPart rock_part(const RegionQuery& region, const ConvexCell& cell, double size) {
  if (!is_near_fitted(region, cell)) return {region.inside(centroid_of(cell)), cell, {}};
  const auto from = point_in_rock(region, cell);
  if (!from) return {false, cell, {}};
  const double reach = reach_of(cell, *from);
  Parting parting(cell, *from, size);
  std::vector<const FittedSurface*> near;
  for (const FittedSurface& surface : region.fitted) {
    if ((surface.closest(*from) - *from).norm() > reach) continue;
    near.push_back(&surface);
    for (const Vec3& foot : surface.feet(*from, reach))
      parting.add({foot, (foot - *from).normalized()}, surface);
  }
  return parting.fitted(near);
}

std::optional<CutPlane> flat_fitted_through(const RegionQuery& region, const ConvexCell& cell) {
  constexpr double kTouching = 1e-6;  // of the cell's reach
  if (region.fitted.empty() || !is_near_fitted(region, cell)) return std::nullopt;
  const Vec3 middle = centroid_of(cell);
  const double reach = reach_of(cell, middle);
  std::optional<CutPlane> best;
  double largest = 0.0;
  for (const Vec3& from : lookouts(cell, middle)) {
    for (const FittedSurface& surface : region.fitted) {
      const Vec3 way = surface.closest(from) - from;
      if (way.norm() < kTouching * reach || way.norm() > 2.0 * reach) continue;
      const CutPlane plane{from + way, way.normalized()};
      const auto halves = divided(cell, plane.point, plane.normal, kTrial);
      if (!halves) continue;
      const double smaller = std::min(volume_of(halves->below), volume_of(halves->above));
      if (is_film(halves->below, reach) || is_film(halves->above, reach)) continue;
      if (smaller <= largest || !bounds_rock_only(surface, halves->below, reach)) continue;
      largest = smaller;
      best = plane;
    }
  }
  return best;
}

}  // namespace muckpile
