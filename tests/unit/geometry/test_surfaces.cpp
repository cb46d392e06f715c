// SPDX-License-Identifier: GPL-2.0-or-later
// Surfaces from triangles and points: what is near and inside, Delaunay triangles, and what is
// refused. Scope: closed forms and brute force; lengths in metres.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/surface/delaunay.h"
#include "geometry/surface/surface_checks.h"
#include "geometry/surface/surface_fit.h"
#include "input_error_of.h"
#include "math/random.h"
#include "surface_shapes.h"

namespace muckpile {
namespace {

Vec3 anywhere(Random& random, double half) {
  const double x = random.uniform(), y = random.uniform(), z = random.uniform();
  return half * (2.0 * Vec3(x, y, z) - Vec3::Ones());
}

// A ball of flat triangles is thinner than the round one by the sagitta of an edge, 5e-3 here.
TEST(SurfaceIndex, KnowsInsideAndDistanceOfABall) {
  const SurfaceIndex ball(test::ball(1.0, 4));
  Random random(1);
  for (int k = 0; k < 2000; ++k) {
    const Vec3 p = anywhere(random, 1.5);
    const double off = p.norm() - 1.0;
    EXPECT_NEAR(ball.closest(p).distance, std::abs(off), 6e-3);
    if (std::abs(off) > 6e-3) {
      EXPECT_EQ(ball.inside(p), off < 0.0);
    }
  }
  EXPECT_NEAR(enclosed_volume(ball.triangles()), 4.0 / 3.0 * std::numbers::pi, 0.02);
  EXPECT_NEAR(rock_volume({test::surface_of(test::ball(1.0, 4))}, {}, Vec3::Constant(-1.1),
                          Vec3::Constant(1.1), 300),
              enclosed_volume(ball.triangles()), 1e-3);
}

// Places on corners and edges of a grid of squares: each is above exactly one triangle.
TEST(SurfaceIndex, LeavesNoGapAtEdges) {
  const SurfaceIndex ground(test::heights(Vec3(0.0, 0.0, 0.0), Vec3(4.0, 4.0, 0.0), 8,
                                          [](double x, double y) { return 0.1 * x * y; }));
  std::vector<SurfaceIndex::Crossing> met;
  for (int i = 1; i < 16; ++i) {
    for (int j = 1; j < 16; ++j) {
      ground.crossings_at(0.25 * i, 0.25 * j, met);
      ASSERT_EQ(met.size(), 1U) << i << ' ' << j;
    }
  }
}

double area_of(const std::vector<Vec2>& points,
               const std::vector<std::array<std::size_t, 3>>& triangles) {
  double area = 0.0;
  for (const auto& [a, b, c] : triangles) {
    const Vec2 u = points[b] - points[a], v = points[c] - points[a];
    const double twice = u.x() * v.y() - u.y() * v.x();
    EXPECT_GT(twice, 0.0);
    area += 0.5 * twice;
  }
  return area;
}

TEST(Delaunay, FillsAGrid) {
  std::vector<Vec2> points;
  for (int k = 0; k < 21 * 21; ++k) points.emplace_back(500.0 + k % 21, 7000.0 + k / 21);
  points.push_back(points[5]);  // a place twice
  const auto triangles = delaunay(points);
  EXPECT_EQ(triangles.size(), 800U);  // two in each of 20 x 20 squares
  EXPECT_NEAR(area_of(points, triangles), 400.0, 1e-9);
}

TEST(Delaunay, LeavesNoPointInACircle) {
  Random random(2);
  std::vector<Vec2> points{{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}};
  for (int k = 0; k < 300; ++k) {
    const double x = random.uniform();
    points.emplace_back(x, random.uniform());
  }
  const auto triangles = delaunay(points);
  EXPECT_EQ(triangles.size(), 602U);  // 2 n - 2 - 4 corners of the hull, n = 304
  EXPECT_NEAR(area_of(points, triangles), 1.0, 1e-9);
  for (const auto& t : triangles) {
    const Vec2 b = points[t[1]] - points[t[0]], c = points[t[2]] - points[t[0]];
    const double d = 2.0 * (b.x() * c.y() - b.y() * c.x());
    const Vec2 middle((c.y() * b.squaredNorm() - b.y() * c.squaredNorm()) / d,
                      (b.x() * c.squaredNorm() - c.x() * b.squaredNorm()) / d);
    for (const Vec2& p : points)
      EXPECT_GT((p - points[t[0]] - middle).norm(), middle.norm() * (1.0 - 1e-9));
  }
  EXPECT_TRUE(delaunay({{0.0, 0.0}, {1.0, 1.0}, {2.0, 2.0}}).empty());
}

TEST(MineFrame, GoesThereAndBack) {
  const MineFrame frame{Vec3(5000.0, 7000.0, 100.0), std::numbers::pi};  // x looks south, y east
  EXPECT_LT((frame.to_run(Vec3(5002.0, 6999.0, 103.0)) - Vec3(1.0, 2.0, 3.0)).norm(), 1e-9);
  EXPECT_LT((frame.to_mine(Vec3(1.0, 2.0, 3.0)) - Vec3(5002.0, 6999.0, 103.0)).norm(), 1e-9);
}

std::string refusal(const test::Triangles& triangles) {
  return input_error_of([&] {
    require_closed(triangles, "it");
    require_outward(SurfaceIndex(triangles), "it");
  });
}

TEST(SurfaceChecks, OpenSurfaceMustBeTurnedAlike) {
  const auto turned_alike = [](const test::Triangles& triangles) {
    return input_error_of([&] { require_turned_alike(triangles, "it", "ground"); });
  };
  test::Triangles open = test::closed_box(Vec3::Constant(-1.0), Vec3::Constant(1.0));
  open.pop_back();
  EXPECT_EQ(turned_alike(open), "");
  // Corners that are one to rounding leave no edge between them.
  open.push_back({Vec3(1, 1, 1), Vec3(1, 1, 1 + 1e-9), Vec3(2, 1, 1)});
  EXPECT_EQ(turned_alike(open), "");
  std::swap(open[0][1], open[0][2]);
  EXPECT_TRUE(turned_alike(open).starts_with(
      "it: has triangles that are turned against each other at 2 edges, one"));
  EXPECT_TRUE(turned_alike(open).ends_with(
      "so that all normals look out of the ground, or take out one of them where they lie on each "
      "other"));
}

TEST(SurfaceChecks, DoubledTrianglesAreLeftOut) {
  const Vec3 a(0, 0, 0), b(1, 0, 0), c(1, 1, 0), d(0, 1, 0);
  test::Triangles mesh{{a, b, c}, {a, c, d}, {b, c, a}, {c, d, a}, {a, b, c}};
  EXPECT_EQ(leave_out_doubled(mesh, "it"), 3U);
  ASSERT_EQ(mesh.size(), 2U);
  EXPECT_EQ(mesh[1][2], d);
  EXPECT_EQ(leave_out_doubled(mesh, "it"), 0U);
  mesh.push_back({a, d, c});
  EXPECT_EQ(input_error_of([&] { (void)leave_out_doubled(mesh, "it"); }),
            "it: has two triangles on each other that look to opposite sides, with a corner at 0 0 "
            "0 m; a wall has ground behind it: take out that which looks into it");
}

TEST(SurfaceChecks, NameWhatIsWrong) {
  const test::Triangles good = test::closed_box(Vec3::Constant(-1.0), Vec3::Constant(1.0));
  EXPECT_EQ(refusal(good), "");
  test::Triangles open = good;
  open.pop_back();
  EXPECT_TRUE(
      refusal(open).starts_with("it: must be a closed surface, has a triangle on one side only at "
                                "3 edges, one of them from"));
  test::Triangles turned = good;
  std::swap(turned[0][1], turned[0][2]);
  EXPECT_TRUE(refusal(turned).starts_with(
      "it: has triangles that are turned against each other at 3 edges"));
  const test::Triangles inward = test::mapped(good, [](const Vec3& p) { return Vec3(-p); });
  EXPECT_TRUE(refusal(inward).starts_with("it: must have triangles that look out of the rock"));
  test::Triangles twice = good;
  for (const StlTriangle& t : test::closed_box(Vec3::Constant(-0.5), Vec3::Constant(1.5)))
    twice.push_back(t);
  EXPECT_TRUE(refusal(twice).starts_with("it: must not overlap itself"));
}

}  // namespace
}  // namespace muckpile
