// SPDX-License-Identifier: GPL-2.0-or-later
// The contact spheres of a block cover its surface up to the gap asked for, and no block that is
// small enough already has more of them.
// Scope: box, plate, tetrahedron and Voronoi cells; lengths in metres.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/spheres/contact_spheres.h"
#include "geometry/spheres/face_planes.h"
#include "math/random.h"
#include "shapes.h"

namespace muckpile {
namespace {

/// Distance of the barest of many random places of the surface from the nearest sphere [m].
double widest_gap(const Polyhedron& shape, const std::vector<Sphere>& spheres) {
  constexpr int kPlaces = 400;  // per triangle
  Random random(5);
  double widest = -std::numeric_limits<double>::infinity();
  for (const std::vector<int>& face : shape.faces) {
    const auto corner = [&](std::size_t k) {
      return shape.vertices[static_cast<std::size_t>(face[k])];
    };
    for (int k = 0; k < kPlaces * static_cast<int>(face.size() - 2); ++k) {
      const auto second = static_cast<std::size_t>(1 + k / kPlaces);
      double u = random.uniform(), v = random.uniform();
      if (u + v > 1.0) u = 1.0 - u, v = 1.0 - v;
      const Vec3 place =
          corner(0) + u * (corner(second) - corner(0)) + v * (corner(second + 1) - corner(0));
      double nearest = std::numeric_limits<double>::infinity();
      for (const Sphere& s : spheres)
        nearest = std::min(nearest, (place - s.centre).norm() - s.radius);
      widest = std::max(widest, nearest);
    }
  }
  return widest;
}

std::vector<Sphere> spheres_in(const Polyhedron& shape, const SphereRule& rule) {
  return contact_spheres(shape, mass_properties(shape).centroid, rule);
}

// Places between those looked at are farther than the gap by at most 0.5 / sqrt(3) of it, and by
// less than half of that where a sphere lies behind them.
constexpr double kBetweenPlaces = 1.15;

/// 1 m long and high, 2 degrees sharp.
Polyhedron sharp_wedge() {
  const double s = std::tan(1.0 * M_PI / 180.0);
  Polyhedron wedge;
  wedge.vertices = {{0, 0, 0}, {1, -s, 0}, {1, s, 0}, {0, 0, 1}, {1, -s, 1}, {1, s, 1}};
  wedge.faces = {{0, 2, 1}, {3, 4, 5}, {0, 1, 4, 3}, {0, 3, 5, 2}, {1, 2, 5, 4}};
  return wedge;
}

TEST(ContactSpheres, StandInSharpWedgesToo) {
  const Polyhedron wedge = sharp_wedge();
  const std::vector<Sphere> spheres =
      spheres_in(wedge, {.count = 1, .growth = 1.0, .surface_gap = 0.25});
  EXPECT_LT(static_cast<int>(spheres.size()), kMostSpheres);
  EXPECT_LE(widest_gap(wedge, spheres), kBetweenPlaces * 0.25);
  const FacePlanes planes(wedge);
  for (const Sphere& sphere : spheres) {
    EXPECT_GT(sphere.radius, 1e-4);
    EXPECT_GE(planes.clearance(sphere.centre), (1.0 - 1e-9) * sphere.radius);
  }
}

TEST(ContactSpheres, CoverTheSurfaceOfBlocksOfAnyShape) {
  const Polyhedron shapes[] = {test::box(Vec3::Zero(), Vec3::Ones()),
                               test::box(Vec3::Zero(), Vec3(0.3, 1.0, 1.5)),
                               test::corner_tetrahedron(), test::voronoi_cell(4)};
  for (const Polyhedron& shape : shapes) {
    const SphereRule few{.count = 5, .growth = 1.19};
    SphereRule rule = few;
    rule.surface_gap = 0.12;
    const std::vector<Sphere> spheres = spheres_in(shape, rule);
    EXPECT_LT(static_cast<int>(spheres.size()), kMostSpheres);
    EXPECT_LT(widest_gap(shape, spheres), kBetweenPlaces * rule.surface_gap);
    EXPECT_GT(widest_gap(shape, spheres_in(shape, few)), 1.5 * rule.surface_gap);
  }
}

TEST(ContactSpheres, AreInsideTheBlockBeforeTheyAreGrown) {
  const Polyhedron plate = test::box(Vec3(1.0, 1.0, 1.0), Vec3(1.2, 2.0, 2.0));
  for (const Sphere& s : spheres_in(plate, {.count = 1, .growth = 1.19, .surface_gap = 0.05})) {
    EXPECT_LE(s.radius / 1.19, FacePlanes(plate).clearance(s.centre) + 1e-12);
    EXPECT_GT(s.radius, 0.01);
  }
}

TEST(ContactSpheres, AreTheUsualOnesWhereTheseLeaveNoLargerGap) {
  const Polyhedron cube = test::box(Vec3::Zero(), Vec3::Ones());
  // A corner without a sphere lies (sqrt 3 - 1) / 2 = 0.366 m off the one in the middle.
  const std::vector<Sphere> usual = spheres_in(cube, {.count = 5});
  const std::vector<Sphere> same = spheres_in(cube, {.count = 5, .surface_gap = 0.37});
  ASSERT_EQ(same.size(), usual.size());
  for (std::size_t k = 0; k < usual.size(); ++k) EXPECT_EQ(same[k].centre, usual[k].centre);
  EXPECT_GT(spheres_in(cube, {.count = 5, .surface_gap = 0.36}).size(), usual.size());
}

TEST(ContactSpheres, AreNoMoreThanSixtyFour) {
  const Polyhedron large = test::box(Vec3::Zero(), Vec3(10.0, 10.0, 1.0));
  EXPECT_EQ(spheres_in(large, {.count = 5, .surface_gap = 0.1}).size(), 64U);
}

TEST(ContactSpheres, AreTheSameForTheSameBlock) {
  const SphereRule rule{.count = 5, .growth = 1.19, .surface_gap = 0.1};
  const std::vector<Sphere> one = spheres_in(test::voronoi_cell(7), rule);
  const std::vector<Sphere> two = spheres_in(test::voronoi_cell(7), rule);
  ASSERT_EQ(one.size(), two.size());
  for (std::size_t k = 0; k < one.size(); ++k) {
    EXPECT_EQ(one[k].centre, two[k].centre);
    EXPECT_EQ(one[k].radius, two[k].radius);
  }
}

TEST(FacePlanes, FindTheNearestPlaceBelowAllFaces) {
  const FacePlanes cube(test::box(Vec3::Zero(), Vec3::Ones()));
  EXPECT_LT((cube.nearest_below(0.2, Vec3::Zero()) - Vec3::Constant(0.2)).norm(), 1e-6);
  EXPECT_LT((cube.nearest_below(0.2, Vec3(0.5, 0.0, 0.4)) - Vec3(0.5, 0.2, 0.4)).norm(), 1e-6);
  EXPECT_EQ(cube.nearest_below(0.2, Vec3(0.3, 0.4, 0.5)), Vec3(0.3, 0.4, 0.5));
  // The oblique face x + y + z = 1 is 0.1 above x = y = z = (1 - 0.1 sqrt 3) / 3.
  const FacePlanes corner(test::corner_tetrahedron());
  const Vec3 below = Vec3::Constant((1.0 - 0.1 * std::sqrt(3.0)) / 3.0);
  EXPECT_LT((corner.nearest_below(0.1, Vec3::Constant(1.0 / 3.0)) - below).norm(), 1e-6);
}

}  // namespace
}  // namespace muckpile
