// SPDX-License-Identifier: GPL-2.0-or-later
// Rock cut to surfaces from files: volume, faces on the surface, and the flat ones as exact as
// those of a region. Scope: scenes of some hundred blocks; lengths in metres.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <functional>
#include <numbers>

#include "cut_checks.h"
#include "geometry/cut/joint_set_cut.h"
#include "geometry/surface/surface_fit.h"
#include "surface_shapes.h"

namespace muckpile {
namespace {

struct CutRock {
  Tessellation cells;
  SurfaceFit fit;
  double volume_error;  // of the rock's volume [-]
};

using Cut = std::function<Tessellation(const TessellationOptions& options)>;

CutRock cut(const std::vector<RockSurface>& surfaces, const Vec3& lo, const Vec3& hi, double size,
            const char* name, const Cut& how = tessellate) {
  TessellationOptions options;
  options.lo = lo;
  options.hi = hi;
  options.size = SizeLaw::uniform(size);
  options.seed = 3;
  options.region = within({}, surfaces);
  CutRock made{how(options), {}, 0.0};
  made.fit = surface_fit(made.cells.blocks, surfaces, lo, hi);
  const double rock = rock_volume(surfaces, {}, lo, hi, 400);
  made.volume_error = made.cells.statistics.block_volume / rock - 1.0;
  std::printf(
      "%s, blocks of %g m: %zu blocks, volume %+.2f %%; faces off by %.3f of a block in the mean "
      "(%+.3f), %.3f at most, %.1f %% within a quarter\n",
      name, size, made.cells.blocks.size(), 100.0 * made.volume_error, made.fit.mean_distance,
      made.fit.mean_offset, made.fit.largest_distance, 100.0 * made.fit.within_a_quarter);
  for (const Block& block : made.cells.blocks) test::expect_convex_and_closed(block);
  (void)test::expect_shared_faces(made.cells.blocks);
  return made;
}

TEST(SurfaceCut, BallHasItsVolume) {
  const std::vector<RockSurface> rock{test::surface_of(test::ball(1.0, 4))};
  for (const double size : {0.15, 0.3}) {
    const CutRock made = cut(rock, Vec3::Constant(-1.1), Vec3::Constant(1.1), size, "ball");
    EXPECT_LT(std::abs(made.volume_error), 0.01);
    EXPECT_LT(made.fit.largest_distance, 0.25);
  }
}

TEST(SurfaceCut, TiltedBoxHasFlatFaces) {
  const Quat turn(Eigen::AngleAxisd(0.4, Vec3(1.0, 2.0, 0.5).normalized()));
  const std::vector<RockSurface> rock{
      test::surface_of(test::mapped(test::closed_box({-1.0, -0.8, -0.7}, {1.0, 0.8, 0.7}),
                                    [&](const Vec3& p) { return Vec3(turn * p); }))};
  const CutRock made = cut(rock, Vec3::Constant(-1.6), Vec3::Constant(1.6), 0.25, "tilted box");
  EXPECT_LT(std::abs(made.volume_error), 1e-3);
  EXPECT_GT(made.fit.within_a_quarter, 0.999);
}

double rough(double x, double y) {
  return 0.25 * std::sin(1.7 * x + 0.4) * std::cos(1.3 * y) + 0.08 * std::sin(5.1 * x - 3.3 * y);
}

TEST(SurfaceCut, RoughGroundIsFollowed) {
  const Vec3 lo(-2.0, -2.0, -2.0), hi(2.0, 2.0, 1.0);
  const std::vector<RockSurface> rock{
      test::surface_of(test::heights(lo - Vec3::Constant(0.5), hi + Vec3::Constant(0.5), 60, rough),
                       SurfaceIs::terrain)};
  for (const double size : {0.25, 0.4}) {
    const CutRock made = cut(rock, lo, hi, size, "rough ground");
    EXPECT_LT(std::abs(made.volume_error), 0.01);
    EXPECT_GT(made.fit.within_a_quarter, 0.95);
  }
}

/// Floor, leaning face and top as one closed body, all rough.
std::vector<RockSurface> rough_bench() {
  auto triangles = test::closed_box({-3.0, -2.0, -1.0}, {0.0, 2.0, 3.0});
  for (int k = 0; k < 4; ++k) triangles = test::halved(triangles);
  return {test::surface_of(test::mapped(triangles, [](const Vec3& p) {
    const double lean = -0.25 * (p.z() + 1.0) * (p.x() + 3.0) / 3.0;
    return Vec3(p.x() + lean + 0.12 * std::sin(2.1 * p.y() + 1.3 * p.z()), p.y(),
                p.z() + 0.1 * std::sin(1.9 * p.x()) * std::cos(1.7 * p.y()));
  }))};
}

TEST(SurfaceCut, RoughBenchIsFollowed) {
  for (const double size : {0.25, 0.4}) {
    const CutRock made =
        cut(rough_bench(), {-4.0, -2.5, -1.5}, {0.5, 2.5, 3.5}, size, "rough bench");
    EXPECT_LT(std::abs(made.volume_error), 0.01);
    EXPECT_GT(made.fit.within_a_quarter, 0.95);
  }
}

/// A floor in front of a bench: an inner edge.
TEST(SurfaceCut, InnerEdgeIsKept) {
  const Vec3 lo(-2.0, -1.0, -1.5), hi(2.0, 1.0, 1.5);
  const auto step = [](double x, double) { return x < 0.0 ? 1.0 : x < 0.3 ? 1.0 - x / 0.3 : 0.0; };
  const std::vector<RockSurface> rock{test::surface_of(
      test::heights(Vec3(-2.1, -1.1, 0.0), Vec3(2.1, 1.1, 0.0), 84, step), SurfaceIs::terrain)};
  const CutRock made = cut(rock, lo, hi, 0.2, "toe and crest");
  EXPECT_LT(std::abs(made.volume_error), 0.01);
  EXPECT_GT(made.fit.within_a_quarter, 0.95);
}

TEST(SurfaceCut, PlaneOfTrianglesIsThePlaneOfARegion) {
  TessellationOptions options;
  options.lo = Vec3(-1.0, -1.0, -1.0);
  options.hi = Vec3(1.0, 1.0, 1.0);
  options.size = SizeLaw::uniform(0.3);
  const Vec3 normal = Vec3(0.2, -0.1, 1.0).normalized();
  options.region.inside = [&](const Vec3& p) { return normal.dot(p) < 0.1; };
  options.region.surface_points = [&](const Vec3& p, double cutoff) {
    const double below = 0.1 - normal.dot(p);
    return below <= cutoff ? std::vector<Vec3>{p + below * normal} : std::vector<Vec3>{};
  };
  const Tessellation exact = tessellate(options);
  const auto plane = [&](double x, double y) {
    return (0.1 - normal.x() * x - normal.y() * y) / normal.z();
  };
  options.region = within(
      {}, {test::surface_of(test::heights(Vec3(-2.0, -2.0, 0.0), Vec3(2.0, 2.0, 0.0), 7, plane),
                            SurfaceIs::terrain)});
  const Tessellation mesh = tessellate(options);
  ASSERT_EQ(mesh.blocks.size(), exact.blocks.size());
  double farthest = 0.0;
  for (std::size_t b = 0; b < mesh.blocks.size(); ++b) {
    farthest =
        std::max(farthest, (mesh.blocks[b].mass.centroid - exact.blocks[b].mass.centroid).norm());
    EXPECT_NEAR(mesh.blocks[b].mass.volume, exact.blocks[b].mass.volume, 1e-6 * 0.027);
  }
  std::printf("plane: centroids differ by %.1e m\n", farthest);
  EXPECT_LT(farthest, 1e-6);
}

TEST(SurfaceCut, BodyBelowATerrainIsBoth) {
  const Vec3 lo = Vec3::Constant(-1.1), hi = Vec3::Constant(1.1);
  const std::vector<RockSurface> rock{
      test::surface_of(test::ball(1.0, 4)),
      test::surface_of(test::heights(2.0 * lo, 2.0 * hi, 10, [](double, double) { return 0.3; }),
                       SurfaceIs::terrain)};
  const CutRock made = cut(rock, lo, hi, 0.2, "ball below a plane");
  EXPECT_LT(std::abs(made.volume_error), 0.01);
  EXPECT_LT(made.fit.largest_distance, 0.35);
}

// Two steep sets and a flat one, none along a wall of the scenes.
Tessellation by_joint_sets(const TessellationOptions& options) {
  const auto normal = [](double dip, double direction) {
    const double d = dip * std::numbers::pi / 180.0, a = direction * std::numbers::pi / 180.0;
    return Vec3(std::sin(d) * std::sin(a), std::sin(d) * std::cos(a), std::cos(d));
  };
  return cut_by_joint_sets(options, {{{normal(75, 80)}, {normal(85, 350)}, {normal(10, 265)}}});
}

void expect_followed(const CutRock& made) {
  EXPECT_LT(std::abs(made.volume_error), 0.01);
  EXPECT_GT(made.fit.within_a_quarter, 0.95);
  // Half of what divisions keep to: what is thinner at a surface is left out.
  EXPECT_EQ(test::slivers(made.cells.blocks, 0.499 * kThinnestPart), 0U);
}

TEST(JointSetsInSurfaces, BallHasItsVolume) {
  const std::vector<RockSurface> rock{test::surface_of(test::ball(1.0, 4))};
  for (const double size : {0.15, 0.3})
    expect_followed(cut(rock, Vec3::Constant(-1.1), Vec3::Constant(1.1), size, "ball, joint sets",
                        by_joint_sets));
}

TEST(JointSetsInSurfaces, TiltedBoxHasFlatFaces) {
  const Quat turn(Eigen::AngleAxisd(0.4, Vec3(1.0, 2.0, 0.5).normalized()));
  const std::vector<RockSurface> rock{
      test::surface_of(test::mapped(test::closed_box({-1.0, -0.8, -0.7}, {1.0, 0.8, 0.7}),
                                    [&](const Vec3& p) { return Vec3(turn * p); }))};
  const CutRock made = cut(rock, Vec3::Constant(-1.6), Vec3::Constant(1.6), 0.25,
                           "tilted box, joint sets", by_joint_sets);
  expect_followed(made);
  EXPECT_LT(std::abs(made.volume_error), 1e-3);
  EXPECT_GT(made.fit.within_a_quarter, 0.999);
}

TEST(JointSetsInSurfaces, RoughGroundIsFollowed) {
  const Vec3 lo(-2.0, -2.0, -2.0), hi(2.0, 2.0, 1.0);
  const std::vector<RockSurface> rock{
      test::surface_of(test::heights(lo - Vec3::Constant(0.5), hi + Vec3::Constant(0.5), 60, rough),
                       SurfaceIs::terrain)};
  for (const double size : {0.25, 0.4})
    expect_followed(cut(rock, lo, hi, size, "rough ground, joint sets", by_joint_sets));
}

// A joint set lies in the ground: no bias by slivers that all are as thin.
TEST(JointSetsInSurfaces, FlatGroundAlongAJointSetKeepsItsVolume) {
  const Vec3 lo(-2.0, -2.0, -2.0), hi(2.0, 2.0, 1.0);
  const auto flat = [](double, double) { return 0.03; };
  const std::vector<RockSurface> rock{
      test::surface_of(test::heights(lo - Vec3::Constant(0.5), hi + Vec3::Constant(0.5), 9, flat),
                       SurfaceIs::terrain)};
  const CutRock made =
      cut(rock, lo, hi, 0.4, "flat ground, joint sets along it", [](const TessellationOptions& o) {
        return cut_by_joint_sets(o, {{{Vec3::UnitX()}, {Vec3::UnitY()}, {Vec3::UnitZ()}}});
      });
  expect_followed(made);
  EXPECT_LT(std::abs(made.volume_error), 1e-6);
}

TEST(JointSetsInSurfaces, RoughBenchIsFollowed) {
  for (const double size : {0.25, 0.4})
    expect_followed(cut(rough_bench(), {-4.0, -2.5, -1.5}, {0.5, 2.5, 3.5}, size,
                        "rough bench, joint sets", by_joint_sets));
}

TEST(JointSetsInSurfaces, InnerEdgeIsKept) {
  const Vec3 lo(-2.0, -1.0, -1.5), hi(2.0, 1.0, 1.5);
  const auto step = [](double x, double) { return x < 0.0 ? 1.0 : x < 0.3 ? 1.0 - x / 0.3 : 0.0; };
  const std::vector<RockSurface> rock{test::surface_of(
      test::heights(Vec3(-2.1, -1.1, 0.0), Vec3(2.1, 1.1, 0.0), 84, step), SurfaceIs::terrain)};
  expect_followed(cut(rock, lo, hi, 0.2, "toe and crest, joint sets", by_joint_sets));
}

TEST(JointSetsInSurfaces, BodyBelowATerrainIsBoth) {
  const Vec3 lo = Vec3::Constant(-1.1), hi = Vec3::Constant(1.1);
  const std::vector<RockSurface> rock{
      test::surface_of(test::ball(1.0, 4)),
      test::surface_of(test::heights(2.0 * lo, 2.0 * hi, 10, [](double, double) { return 0.3; }),
                       SurfaceIs::terrain)};
  expect_followed(cut(rock, lo, hi, 0.2, "ball below a plane, joint sets", by_joint_sets));
}

}  // namespace
}  // namespace muckpile
