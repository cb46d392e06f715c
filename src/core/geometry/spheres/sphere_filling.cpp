// SPDX-License-Identifier: GPL-2.0-or-later
// Spheres inside a convex block: one large in the middle, equal smaller ones towards the corners.
// Scope: corners are served farthest first; a corner sphere's radius trades reach for volume.
#include "geometry/spheres/sphere_filling.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <string>
#include <tuple>
#include <utility>

#include "args/input_error.h"
#include "geometry/spheres/face_planes.h"

namespace muckpile {
namespace {

// Radius of the corner spheres over that of the inscribed sphere. Measured on relaxed Voronoi cells
// with eight spheres: 0.3 / 0.4 / 0.5 / 0.6 / 0.7 cover 55 / 60 / 63 / 63 / 61 % of the volume and
// leave the worst corner bare by 0.25 / 0.25 / 0.26 / 0.27 / 0.30 V^(1/3).
constexpr double kCornerRadius = 0.5;
constexpr double kServed = -std::numeric_limits<double>::infinity();
// Rounding in the planes must not let a sphere out.
constexpr double kInset = 1e-12;

Sphere inset(const Vec3& centre, double clearance) {
  return {centre, clearance - kInset * (centre.cwiseAbs().maxCoeff() + clearance)};
}

// Largest inscribed sphere to about 1 %: steps away from the nearest face, ever shorter.
Sphere inscribed_sphere(const FacePlanes& planes, const Vec3& start) {
  constexpr int kSteps = 150;
  constexpr double kShrink = 0.95;
  Vec3 at = start, best = start;
  auto [clearance, plane] = planes.nearest(start);
  double best_clearance = clearance;
  double step = 0.3 * best_clearance;
  for (int k = 0; k < kSteps; ++k, step *= kShrink) {
    at -= step * planes.normal(plane);
    std::tie(clearance, plane) = planes.nearest(at);
    if (clearance <= best_clearance) continue;
    best_clearance = clearance;
    best = at;
  }
  return inset(best, best_clearance);
}

// The sphere of a given radius on the way from the middle to a corner, as far out as it fits; in
// the middle if it fits nowhere.
Sphere corner_sphere(const FacePlanes& planes, const Vec3& middle, const Vec3& corner,
                     double radius) {
  const Vec3 way = corner - middle;
  const Vec3 centre = middle + std::clamp(planes.way_to(radius, middle, way), 0.0, 1.0) * way;
  return inset(centre, planes.clearance(centre));
}

// Every body has corners; should rounding hide them, all vertices serve.
std::vector<Vec3> corners_of(const Polyhedron& shape, const FacePlanes& planes, double size) {
  std::vector<Vec3> corners;
  std::copy_if(shape.vertices.begin(), shape.vertices.end(), std::back_inserter(corners),
               [&](const Vec3& v) { return planes.is_corner(v, size); });
  return corners.size() < 4 ? shape.vertices : corners;
}

double gap(const Vec3& corner, const Sphere& sphere) {
  return (corner - sphere.centre).norm() - sphere.radius;
}

double nearest_gap(const Vec3& corner, const std::vector<Sphere>& spheres) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Sphere& sphere : spheres) nearest = std::min(nearest, gap(corner, sphere));
  return nearest;
}

}  // namespace

std::vector<Sphere> fill_with_spheres(const Polyhedron& shape, const Vec3& centroid, int count) {
  if (count < 1) {
    throw InputError("sphere filling: spheres per block must be >= 1, got '" +
                     std::to_string(count) + "'");
  }
  const FacePlanes planes(shape);
  std::vector<Sphere> spheres = {inscribed_sphere(planes, centroid)};
  const Sphere middle = spheres.front();
  const std::vector<Vec3> corners = corners_of(shape, planes, middle.radius);
  std::vector<double> gaps;  // per corner: to the nearest sphere, served ones -infinity [m]
  for (const Vec3& corner : corners) gaps.push_back(gap(corner, middle));
  double radius = kCornerRadius * middle.radius;
  while (static_cast<int>(spheres.size()) < count) {
    auto farthest = std::max_element(gaps.begin(), gaps.end()) - gaps.begin();
    if (gaps[static_cast<std::size_t>(farthest)] == kServed) {  // more spheres than corners
      radius *= kCornerRadius;
      for (std::size_t v = 0; v < gaps.size(); ++v) gaps[v] = nearest_gap(corners[v], spheres);
      farthest = std::max_element(gaps.begin(), gaps.end()) - gaps.begin();
    }
    const Vec3& corner = corners[static_cast<std::size_t>(farthest)];
    spheres.push_back(corner_sphere(planes, middle.centre, corner, radius));
    for (std::size_t v = 0; v < gaps.size(); ++v) {
      gaps[v] = std::min(gaps[v], gap(corners[v], spheres.back()));
    }
    gaps[static_cast<std::size_t>(farthest)] = kServed;
  }
  return spheres;
}

}  // namespace muckpile
