// SPDX-License-Identifier: GPL-2.0-or-later
// Where spheres touch planes and meshes: faces, edges, corners, valleys, from before and behind.
// Scope: geometry worked by hand.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iostream>
#include <random>
#include <vector>

#include "flat_mesh.h"
#include "wall/wall_mesh.h"
#include "wall/wall_plane.h"

namespace muckpile::test {
namespace {

constexpr double kRadius = 0.5;  // [m]

std::vector<WallTouch> touches_of(const WallSurface& wall, const Vec3& centre,
                                  double radius = kRadius) {
  std::vector<std::size_t> parts;
  WallTouches touches;
  if (std::isinf(wall.distance(centre, radius + 0.1, parts))) return {};
  wall.find_touches(centre, radius, parts, touches);
  return {touches.all().begin(), touches.all().end()};
}

/// Ground z < 0 for x < 0, and a slope that rises from the y axis at an angle [deg]; negative: it
/// falls.
WallMesh bent(double angle) {
  const double a = angle * M_PI / 180.0;
  std::vector<StlTriangle> mesh;
  add_panel(mesh, {-4, -4, 0}, {0, -4, 0}, {0, 4, 0}, {-4, 4, 0});
  const Vec3 up(4 * std::cos(a), 0, 4 * std::sin(a));
  add_panel(mesh, {0, -4, 0}, Vec3(0, -4, 0) + up, Vec3(0, 4, 0) + up, {0, 4, 0});
  return WallMesh(std::move(mesh));
}

TEST(WallPlane, TouchIsRadiusLessHeightDeepOnEitherSide) {
  const WallPlane plane({0, 0, 1}, {0, 0, 5});
  EXPECT_TRUE(touches_of(plane, {3, 4, 1.6}).empty());
  ASSERT_EQ(touches_of(plane, {3, 4, 1.4}).size(), 1u);
  EXPECT_NEAR(touches_of(plane, {3, 4, 1.4})[0].overlap, 0.1, 1e-15);
  EXPECT_NEAR(touches_of(plane, {3, 4, -7.0})[0].overlap, 8.5, 1e-14);
  EXPECT_EQ(touches_of(plane, {3, 4, 1.4})[0].normal, Vec3(0, 0, 1));
  EXPECT_NEAR(plane.depth({0, 0, 0.75}), 0.25, 1e-15);
  EXPECT_EQ(plane.depth({0, 0, 1.25}), 0.0);
}

/// Triangles of some 0.3 m under a sphere of 1 m, at places at random, some on edges and corners;
/// the floor level, and tilted a long way off.
TEST(WallMesh, FlatFloorOfUnevenTrianglesIsOneTouchEverywhere) {
  const Mat3 tilted = Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  double worst = 0.0;
  for (const bool far : {false, true}) {
    const Mat3 turn = far ? tilted : Mat3(Mat3::Identity());
    const auto placed = [&](const Vec3& p) {
      return Vec3(turn * p + (far ? 1.0 : 0.0) * Vec3(700, -400, 50));
    };
    std::vector<StlTriangle> triangles = uneven_floor(3.0, 20, 7);
    const std::vector<StlTriangle> level = triangles;
    for (StlTriangle& t : triangles)
      for (Vec3& corner : t) corner = placed(corner);
    const WallMesh floor(triangles);
    std::mt19937 random(3);
    std::uniform_real_distribution<double> place(-2.0, 2.0), height(-0.3, 0.5);
    for (std::size_t k = 0; k < 4000; ++k) {
      Vec3 at(place(random), place(random), height(random));
      const StlTriangle& near = level[k % level.size()];
      if (k % 4 == 0) at.head<2>() = near[0].head<2>();
      if (k % 4 == 1) at.head<2>() = (0.3 * near[0] + 0.7 * near[1]).head<2>();
      if (at.head<2>().cwiseAbs().maxCoeff() > 2.4) continue;
      const auto touches = touches_of(floor, placed(at));
      ASSERT_EQ(touches.size(), 1u) << at.transpose();
      worst = std::max({worst, (touches[0].normal - turn.col(2)).norm(),
                        std::abs(touches[0].overlap - (kRadius - at.z()))});
    }
  }
  std::cout << "flat mesh: overlap and normal off by " << worst << "\n";
  EXPECT_LT(worst, 1e-9);  // 1e-13 m at 800 m, over the least distance of a centre from an edge
}

/// A long triangle beside two short ones.
TEST(WallMesh, CornerOnTheEdgeOfALargerTriangleIsNoTouch) {
  const WallMesh floor({{Vec3(-4, -4, 0), Vec3(4, -4, 0), Vec3(4, 4, 0)},
                        {Vec3(-4, -4, 0), Vec3(1, 1, 0), Vec3(-4, 4, 0)},
                        {Vec3(1, 1, 0), Vec3(4, 4, 0), Vec3(-4, 4, 0)}});
  for (const double x : {0.8, 1.0, 1.2}) {
    for (const double y : {0.8, 1.0, 1.2}) {
      const auto touches = touches_of(floor, {x, y, 0.3});
      ASSERT_EQ(touches.size(), 1u) << x << " " << y;
      EXPECT_NEAR((touches[0].normal - Vec3::UnitZ()).norm(), 0.0, 1e-12);
      EXPECT_NEAR(touches[0].overlap, 0.2, 1e-12);
    }
  }
}

/// Behind that corner, whichever triangle is looked at first, and behind a seam of panels that do
/// not fit together corner to corner.
TEST(WallMesh, CentreBehindACornerOnALargerTriangleIsPushedOut) {
  std::vector<StlTriangle> corner{{Vec3(-4, -4, 0), Vec3(4, -4, 0), Vec3(4, 4, 0)},
                                  {Vec3(-4, -4, 0), Vec3(1, 1, 0), Vec3(-4, 4, 0)},
                                  {Vec3(1, 1, 0), Vec3(4, 4, 0), Vec3(-4, 4, 0)}};
  std::vector<StlTriangle> seam;
  for (const double y : {-4.0, 0.0, 4.0})
    add_panel(seam, {-4, y - 2, 0}, {1, y - 2, 0}, {1, y + 2, 0}, {-4, y + 2, 0});
  for (const double y : {-3.0, 1.0, 5.0})
    add_panel(seam, {1, y - 2, 0}, {4, y - 2, 0}, {4, y + 2, 0}, {1, y + 2, 0});
  for (std::vector<StlTriangle>* mesh : {&corner, &seam}) {
    for (std::size_t turn = 0; turn < mesh->size(); ++turn) {
      std::ranges::rotate(*mesh, mesh->begin() + 1);
      const WallMesh floor(*mesh);
      for (const double y : {-1.0, 1.0, 1.2, 2.0, 3.0}) {
        for (const double depth : {0.01, 0.2, 0.45}) {
          const Vec3 centre(mesh == &corner ? y : 1.0, y, -depth);
          const auto touches = touches_of(floor, centre);
          ASSERT_EQ(touches.size(), 1u) << centre.transpose();
          EXPECT_NEAR((touches[0].normal - Vec3::UnitZ()).norm(), 0.0, 1e-9) << centre.transpose();
          EXPECT_NEAR(touches[0].overlap, kRadius + depth, 1e-9) << centre.transpose();
          EXPECT_NEAR(floor.depth(centre), depth, 1e-9) << centre.transpose();
        }
      }
    }
  }
}

TEST(WallMesh, OuterEdgeIsOneTouchAlongTheLineFromIt) {
  const WallMesh ridge = bent(-90.0);
  // 0.3 beside the edge and 0.2 above it: distance sqrt(0.09 + 0.04).
  const auto touches = touches_of(ridge, {0.3, 0.7, 0.2});
  ASSERT_EQ(touches.size(), 1u);
  EXPECT_NEAR(touches[0].overlap, kRadius - std::sqrt(0.13), 1e-12);
  EXPECT_NEAR((touches[0].normal - Vec3(0.3, 0, 0.2).normalized()).norm(), 0.0, 1e-12);
}

TEST(WallMesh, SteepValleyIsTwoTouchesAndAFlatOneTheNearer) {
  const auto steep = touches_of(bent(90.0), {-0.3, 0.1, 0.4});
  ASSERT_EQ(steep.size(), 2u);
  EXPECT_NEAR((steep[0].normal - Vec3(-1, 0, 0)).norm(), 0.0, 1e-12);
  EXPECT_NEAR(steep[0].overlap, 0.2, 1e-12);
  EXPECT_NEAR((steep[1].normal - Vec3(0, 0, 1)).norm(), 0.0, 1e-12);
  EXPECT_NEAR(steep[1].overlap, 0.1, 1e-12);
  const auto flat = touches_of(bent(10.0), {-0.05, 0.1, 0.4});
  ASSERT_EQ(flat.size(), 1u);
  EXPECT_NEAR(flat[0].overlap, 0.1, 1e-12);  // floor: 0.4 away; slope: 0.4 cos 10 + 0.05 sin 10
  const auto beyond = touches_of(bent(10.0), {0.2, 0.1, 0.4});
  ASSERT_EQ(beyond.size(), 1u);
  const double a = 10.0 * M_PI / 180.0;
  EXPECT_NEAR((beyond[0].normal - Vec3(-std::sin(a), 0, std::cos(a))).norm(), 0.0, 1e-12);
}

TEST(WallMesh, CentreBehindAFaceIsPushedOutThroughTheNearest) {
  const auto floor = touches_of(WallMesh(uneven_floor(3.0, 6, 1)), {0.2, 0.3, -0.1});
  ASSERT_EQ(floor.size(), 1u);
  EXPECT_NEAR(floor[0].overlap, kRadius + 0.1, 1e-12);
  EXPECT_NEAR((floor[0].normal - Vec3::UnitZ()).norm(), 0.0, 1e-12);
  const auto ridge = touches_of(bent(-90.0), {-0.1, 0.2, -0.25});
  ASSERT_EQ(ridge.size(), 1u);
  EXPECT_NEAR((ridge[0].normal - Vec3::UnitX()).norm(), 0.0, 1e-12);
  EXPECT_NEAR(ridge[0].overlap, kRadius + 0.1, 1e-12);
}

/// Behind a valley of 90 degrees the edge is nearest: the way out is towards it.
TEST(WallMesh, CentreBehindAValleyIsPushedOutAtItsEdge) {
  const auto touches = touches_of(bent(90.0), {0.06, 0.5, -0.08});
  ASSERT_EQ(touches.size(), 1u);
  EXPECT_NEAR((touches[0].normal - Vec3(-0.6, 0, 0.8)).norm(), 0.0, 1e-12);
  EXPECT_NEAR(touches[0].overlap, kRadius + 0.1, 1e-12);
}

/// A tip of four sides, seen from above and from inside; its corner is no border.
TEST(WallMesh, TipPushesAwayAndBehindItASideIsNearest) {
  const Vec3 tip(0, 0, 1);
  const std::vector<Vec3> base{{2, 2, -1}, {-2, 2, -1}, {-2, -2, -1}, {2, -2, -1}};
  std::vector<StlTriangle> mesh;
  for (std::size_t k = 0; k < 4; ++k) mesh.push_back({tip, base[k], base[(k + 1) % 4]});
  const WallMesh pyramid(mesh);
  const auto above = touches_of(pyramid, {0.01, 0.02, 1.4});
  ASSERT_EQ(above.size(), 1u);
  EXPECT_NEAR((above[0].normal - Vec3(0.01, 0.02, 0.4).normalized()).norm(), 0.0, 1e-9);
  const auto below = touches_of(pyramid, {0.1, 0.0, 0.8});
  ASSERT_EQ(below.size(), 1u);
  EXPECT_NEAR((below[0].normal - Vec3(1, 0, 1).normalized()).norm(), 0.0, 1e-9);
  EXPECT_GT(below[0].overlap, kRadius);
}

/// What rolls over the end of a floor is pushed away by its border, from above as from below.
TEST(WallMesh, WhereTheSurfaceEndsItsBorderPushesAway) {
  const WallMesh floor(uneven_floor(1.0, 4, 2));
  for (const double z : {0.2, 0.0, -0.2}) {
    const auto touches = touches_of(floor, {1.2, 0.1, z});
    ASSERT_EQ(touches.size(), 1u) << z;
    EXPECT_NEAR((touches[0].normal - Vec3(0.2, 0, z).normalized()).norm(), 0.0, 1e-12);
    EXPECT_LT(touches[0].overlap, kRadius);
    EXPECT_EQ(floor.depth({1.2, 0.1, z}), 0.0);
  }
  const auto corner = touches_of(floor, {1.1, 1.1, -0.1});
  ASSERT_EQ(corner.size(), 1u);
  EXPECT_NEAR((corner[0].normal - Vec3(1, 1, -1).normalized()).norm(), 0.0, 1e-12);
}

TEST(WallMesh, DepthIsThatBehindAFace) {
  const WallMesh floor(uneven_floor(3.0, 6, 1));
  EXPECT_NEAR(floor.depth({0.2, 0.3, -1.7}), 1.7, 1e-12);
  EXPECT_EQ(floor.depth({0.2, 0.3, 1.7}), 0.0);
}

/// Over and under the diagonal of a floor of two triangles, the edge of a ridge and its end.
TEST(WallMesh, DepthUnderAnEdgeHasTheSignOfATouch) {
  std::vector<StlTriangle> two;
  add_panel(two, {-4, -4, 0}, {4, -4, 0}, {4, 4, 0}, {-4, 4, 0});
  const WallMesh floor(two);
  EXPECT_NEAR(floor.depth({0.5, 0.5, -1.7}), 1.7, 1e-12);
  EXPECT_EQ(floor.depth({0.5, 0.5, 1.7}), 0.0);
  EXPECT_EQ(floor.depth({0.5, 0.5, 0.0}), 0.0);
  EXPECT_EQ(floor.depth({4.5, 0.5, -0.5}), 0.0);
  const WallMesh valley = bent(90.0);
  EXPECT_NEAR(valley.depth({0.06, 0.5, -0.08}), 0.1, 1e-12);
  EXPECT_EQ(bent(-90.0).depth({0.3, 0.7, 0.2}), 0.0);
}

/// The tree gives what a look at each triangle gives.
TEST(WallMesh, NearTrianglesAreThoseWithinReach) {
  const std::vector<StlTriangle> triangles = uneven_floor(50.0, 40, 5);
  const WallMesh floor(triangles);
  std::mt19937 random(9);
  std::uniform_real_distribution<double> place(-55.0, 55.0), height(-3.0, 8.0);
  for (int k = 0; k < 200; ++k) {
    const Vec3 at(place(random), place(random), height(random));
    std::vector<std::size_t> parts, expected;
    for (std::size_t t = 0; t < triangles.size(); ++t)
      if ((closest_on(triangles[t], at).at - at).norm() <= 4.0) expected.push_back(t);
    EXPECT_EQ(std::isfinite(floor.distance(at, 4.0, parts)), !expected.empty());
    std::ranges::sort(parts);
    EXPECT_EQ(parts, expected);
  }
}

}  // namespace
}  // namespace muckpile::test
