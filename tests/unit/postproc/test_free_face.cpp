// SPDX-License-Identifier: GPL-2.0-or-later
// The plane of a bench's free face, for both kinds of cut, upright and leaning.
// Scope: measure/free_face.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bond/build/joint_plane.h"
#include "geometry/cut/joint_set_cut.h"
#include "geometry/cut/tessellation.h"
#include "measure/free_face.h"
#include "synthetic_run.h"

namespace muckpile {
namespace {

using namespace testing;

constexpr double kNear = 0.02;  // [m]
constexpr double kUpright = 0.5 * std::numbers::pi;

// 3 m of rock above the floor and 1 m below it.
TessellationOptions rock() {
  TessellationOptions options;
  options.lo = Vec3(-3.0, -1.0, -1.0);
  options.hi = Vec3(0.0, 1.0, 3.0);
  options.holes = {{Vec3(-1.5, 0.0, -0.5), Vec3(-1.5, 0.0, 2.0), 0.2}};
  options.size = SizeLaw::power({0.5, 1.0}, {0.25, 0.6});
  options.sweeps = 3;
  return options;
}

// Rock that leans back by 0.5 per height, cubes of 0.5 m cut along the slope.
TEST(FaceMap, OfATiltedFaceIsThatFace) {
  std::vector<Block> blocks = cubes_in({-3.0, -1.0, 0.0}, {0.0, 1.0, 3.0});
  shear(blocks, 180.0 / std::numbers::pi * std::atan(2.0));
  const auto face = face_map(as_start_blocks(blocks));
  ASSERT_NE(face, nullptr);
  const double line = kCube / 4;
  for (const double z : {0.5 * line, 1.5 + 0.5 * line, 2.5 + 0.5 * line})
    for (const double y : {-0.9, 0.0, 0.9}) EXPECT_NEAR(face->x(y, z), -0.5 * z, 1e-9);
  EXPECT_NEAR(face->toe(0.0), 0.0, 0.5 * line);
  EXPECT_NEAR(face->middle(), -0.75, line);
  const std::vector<Vec2> section = face->section(0.3);
  ASSERT_GE(section.size(), 23U);
  for (const Vec2& p : section) EXPECT_NEAR(p.x(), -0.5 * p.y(), 1e-9);
}

// Of two steps the upper one is short: above it the face goes on as it ends, and in a gap along the
// bench it is that of the rock beside it.
TEST(FaceMap, GoesOnWhereThereIsNoRock) {
  std::vector<Block> blocks = cubes_in({-3.0, -1.0, 0.0}, {0.0, -0.5, 2.0});
  for (const Block& block : cubes_in({-3.0, 0.5, 0.0}, {-1.0, 1.0, 1.0})) blocks.push_back(block);
  const auto face = face_map(as_start_blocks(blocks));
  EXPECT_NEAR(face->x(-0.7, 1.9), 0.0, 1e-9);
  EXPECT_NEAR(face->x(0.7, 0.5), -1.0, 1e-9);
  EXPECT_NEAR(face->x(0.7, 1.9), -1.0, 1e-9);
  EXPECT_NEAR(face->x(0.3, 0.5), -1.0, 1e-9);
  EXPECT_NEAR(face->x(-0.3, 0.5), 0.0, 1e-9);
  EXPECT_EQ(face->section(0.7).size(), 8U);
  EXPECT_EQ(std::ranges::count(face->at_face(), 1), 4 + 2);
}

void expect_upright(const std::vector<Block>& blocks) {
  const FreeFace face = free_face(as_start_blocks(blocks), kNear);
  EXPECT_EQ(face.off_plane, 0.0);
  EXPECT_EQ(face.back, 0.0);
  EXPECT_NEAR(face.x_low, 0.0, 1e-9);
  EXPECT_NEAR(face.x_high, 0.0, 1e-9);
  EXPECT_NEAR(face.slope, kUpright, 1e-9);
}

TEST(FreeFace, OfAVoronoiCutIsItsPlane) { expect_upright(tessellate(rock()).blocks); }

TEST(FreeFace, OfLeaningJointSetsIsItsPlaneTooIfTheFaceIsUpright) {
  const JointSetCut leaning{
      {{normal_of_dip(1.31, 1.57)}, {normal_of_dip(1.48, 0.0)}, {normal_of_dip(0.17, 4.71)}}};
  expect_upright(cut_by_joint_sets(rock(), leaning).blocks);
}

TEST(FreeFace, ThatLeansIsSeenWithItsSlope) {
  std::vector<Block> blocks = tessellate(rock()).blocks;
  shear(blocks, 76.0);
  const FreeFace face = free_face(as_start_blocks(blocks), kNear);
  EXPECT_EQ(face.off_plane, 0.0);
  EXPECT_NEAR(face.back, 1.0 / std::tan(76.0 * std::numbers::pi / 180.0), 1e-9);
  EXPECT_NEAR(face.slope, 76.0 * std::numbers::pi / 180.0, 1e-9);
  EXPECT_NEAR(face.x_low, -3.0 / std::tan(76.0 * std::numbers::pi / 180.0), 0.05);
  EXPECT_NEAR(face.x_high, 0.0, 0.05);
}

TEST(FreeFace, ThatLeansForwardIsOffThePlane) {
  std::vector<Block> blocks = tessellate(rock()).blocks;
  shear(blocks, 104.0);
  const FreeFace face = free_face(as_start_blocks(blocks), kNear);
  EXPECT_GT(face.off_plane, 0.9);
  EXPECT_EQ(face.back, 0.0);
}

TEST(FreeFace, ThatStandsElsewhereIsOffThePlane) {
  std::vector<StartBlock> blocks = as_start_blocks(cubes_in({-3.0, -1.0, 0.0}, {0.5, 1.0, 3.0}));
  EXPECT_EQ(free_face(blocks, kNear).off_plane, 1.0);
}

TEST(FreeFace, WithANotchIsOffThePlaneThere) {
  std::vector<Block> blocks = cubes_in({-3.0, -1.0, -1.0}, {0.0, 1.0, 3.0});
  // One of the 4 x 6 cubes of the face above the floor is missing.
  std::erase_if(blocks, [](const Block& b) {
    return (b.mass.centroid - Vec3(-0.25, 0.25, 1.25)).norm() < 1e-9;
  });
  const FreeFace face = free_face(as_start_blocks(blocks), kNear);
  EXPECT_NEAR(face.off_plane, 1.0 / 24.0, 1e-12);
  EXPECT_NEAR(face.x_low, -kCube, 1e-9);
}

TEST(FreeFace, OfRockBelowTheFloorIsNone) {
  EXPECT_EQ(
      free_face(as_start_blocks(cubes_in({-3.0, -1.0, -1.0}, {0.0, 1.0, 0.0})), kNear).off_plane,
      1.0);
}

}  // namespace
}  // namespace muckpile
