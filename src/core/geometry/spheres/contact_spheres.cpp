// SPDX-License-Identifier: GPL-2.0-or-later
// Spheres that cover the surface of a block, the barest place first.
// Scope: see the header.
#include "geometry/spheres/contact_spheres.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "geometry/spheres/face_planes.h"

namespace muckpile {
namespace {

// Of the gap: that a new sphere leaves at the place that it is for. Smaller ones make it reach less
// far along an edge, larger ones need more spheres around: 0.3 / 0.45 / 0.6 / 0.75 take 22 / 20 /
// 20 / 19 thousand for a crater in jointed rock.
constexpr double kLeft = 0.6;

double distance_from(const Sphere& sphere, const Vec3& place) {
  return (place - sphere.centre).norm() - sphere.radius;
}

/// Corners of equal triangles of at most `spacing` [m].
void add_places(const Vec3& a, const Vec3& b, const Vec3& c, double spacing,
                std::vector<Vec3>& places) {
  const double longest = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
  const int steps = std::max(1, static_cast<int>(std::ceil(longest / spacing)));
  for (int i = 0; i <= steps; ++i)
    for (int j = 0; j <= steps - i; ++j)
      places.emplace_back(a + (i * (b - a) + j * (c - a)) / steps);
}

/// Of the surface, less than `spacing` [m] from each other, or than a hundredth of the block.
std::vector<Vec3> places_on(const Polyhedron& shape, double spacing) {
  double extent = 0.0;
  for (const Vec3& v : shape.vertices)
    extent = std::max(extent, (v - shape.vertices.front()).norm());
  std::vector<Vec3> places;
  for (const std::vector<int>& face : shape.faces) {
    const auto corner = [&](std::size_t k) {
      return shape.vertices[static_cast<std::size_t>(face[k])];
    };
    for (std::size_t k = 1; k + 1 < face.size(); ++k)
      add_places(corner(0), corner(k), corner(k + 1), std::max(spacing, 0.01 * extent), places);
  }
  return places;
}

/// The largest sphere that leaves a place of the surface bare by no more than `gap` [m]. The gap
/// that the nearest one of a radius leaves is a convex function of the radius, from 0 on. In a
/// sharp wedge, where that one is not found, it stands on the way to the middle of the block, whose
/// clearance grows at least in proportion.
Sphere largest_at(const Vec3& place, double gap, double growth, const Sphere& middle,
                  const FacePlanes& planes) {
  constexpr int kHalvings = 12;
  const double largest = middle.radius / growth;
  const auto nearest = [&](double radius) {
    Vec3 centre = planes.nearest_below(radius, place);
    if (planes.clearance(centre) < 0.5 * radius)
      centre = place + radius / largest * (middle.centre - place);
    return Sphere{centre, growth * std::clamp(planes.clearance(centre), 0.0, radius)};
  };
  Sphere best = nearest(largest);
  if (distance_from(best, place) <= gap) return best;
  double low = 0.0, high = largest;
  for (int k = 0; k < kHalvings; ++k) {
    const double radius = 0.5 * (low + high);
    const Sphere sphere = nearest(radius);
    const bool near = distance_from(sphere, place) <= gap;
    (near ? low : high) = radius;
    if (near) best = sphere;
  }
  return best;
}

/// How far places of a surface lie from the nearest sphere.
class BarePlaces {
 public:
  explicit BarePlaces(std::vector<Vec3> places)
      : places_(std::move(places)),
        distances_(places_.size(), std::numeric_limits<double>::infinity()) {}

  void add(const Sphere& sphere) {
    for (std::size_t k = 0; k < places_.size(); ++k)
      distances_[k] = std::min(distances_[k], distance_from(sphere, places_[k]));
  }
  [[nodiscard]] double widest_gap() const {
    return *std::max_element(distances_.begin(), distances_.end());
  }
  [[nodiscard]] const Vec3& barest() const {
    const auto widest = std::max_element(distances_.begin(), distances_.end());
    return places_[static_cast<std::size_t>(widest - distances_.begin())];
  }

 private:
  std::vector<Vec3> places_;
  std::vector<double> distances_;  // [m]
};

/// No place of a convex block lies farther from a sphere than one of its corners does.
double farthest_corner(const Polyhedron& shape, const Sphere& sphere) {
  double farthest = 0.0;
  for (const Vec3& v : shape.vertices) farthest = std::max(farthest, distance_from(sphere, v));
  return farthest;
}

/// From the sphere in the middle on.
std::vector<Sphere> covering_spheres(const Polyhedron& shape, const Sphere& middle,
                                     const SphereRule& rule, BarePlaces bare) {
  const FacePlanes planes(shape);
  std::vector<Sphere> spheres{middle};
  bare.add(middle);
  while (static_cast<int>(spheres.size()) < kMostSpheres &&
         (static_cast<int>(spheres.size()) < rule.count || bare.widest_gap() > rule.surface_gap)) {
    spheres.push_back(
        largest_at(bare.barest(), kLeft * rule.surface_gap, rule.growth, middle, planes));
    bare.add(spheres.back());
  }
  return spheres;
}

}  // namespace

std::vector<Sphere> contact_spheres(const Polyhedron& shape, const Vec3& centroid,
                                    const SphereRule& rule) {
  std::vector<Sphere> spheres = fill_with_spheres(shape, centroid, rule.count);
  for (Sphere& sphere : spheres) sphere.radius *= rule.growth;
  if (farthest_corner(shape, spheres.front()) <= rule.surface_gap) return spheres;
  const BarePlaces bare(places_on(shape, 0.5 * rule.surface_gap));
  BarePlaces left = bare;
  for (const Sphere& sphere : spheres) left.add(sphere);
  if (left.widest_gap() > rule.surface_gap)
    return covering_spheres(shape, spheres.front(), rule, bare);
  return spheres;
}

}  // namespace muckpile
