// SPDX-License-Identifier: GPL-2.0-or-later
// Holes narrow against their blocks: the void is the cylinder's, blocks are whole, and holes that
// leave no room are refused.
// Scope: boxes of some hundred blocks of about 1 m; lengths in metres.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <numbers>
#include <string>
#include <vector>

#include "cut_checks.h"
#include "geometry/cut/hole_rings.h"
#include "geometry/cut/tessellation.h"
#include "geometry/holes/hole_surface.h"
#include "input_error_of.h"

namespace muckpile {
namespace {

constexpr double kExact = 1e-6;  // vertices of two cells agree to 1e-7 of a block

/// A box of 8 x 8 x 7 m in blocks of 1 m.
TessellationOptions box() {
  TessellationOptions options;
  options.lo = Vec3(-4.0, -4.0, 0.0);
  options.hi = Vec3(4.0, 4.0, 7.0);
  options.size = SizeLaw::uniform(1.0);
  options.seed = 3;
  return options;
}

TessellationOptions with_holes(std::vector<Hole> holes) {
  TessellationOptions options = box();
  options.holes = std::move(holes);
  return options;
}

double cylinders(const std::vector<Hole>& holes) {
  double sum = 0.0;
  for (const Hole& hole : holes) sum += cylinder_volume(hole);
  return sum;
}

/// All of the rock but so much of the cylinders is in whole blocks, and each void is closed.
void expect_exact_voids(const TessellationOptions& options, double share = 1.0) {
  const Tessellation cut = tessellate(options);
  const double rock = (options.hi - options.lo).prod(), gone = share * cylinders(options.holes);
  test::expect_sound_cut(cut.blocks, rock - gone);
  EXPECT_NEAR(cut.statistics.void_volume, gone, kExact * gone);
  for (std::size_t h = 0; h < options.holes.size(); ++h) {
    const double volume = share * cylinder_volume(options.holes[h]);
    EXPECT_NEAR(cut.statistics.hole_volume[h], volume, kExact * volume) << "hole " << h + 1;
  }
  EXPECT_EQ(test::slivers(cut.blocks, 0.15), 0u);
}

TEST(HoleRings, TheVoidIsTheCylinderForBlocksOf150ToSixRadii) {
  for (const double radius : {0.66, 0.57, 0.5, 0.45, 1.0 / 3.0, 0.25, 1.0 / 6.0})
    expect_exact_voids(with_holes({{Vec3(0.2, 0.1, 0.0), Vec3(0.2, 0.1, 7.0), radius}}));
}

// As around a hole of a bench: sizes grow with the square of the distance, from those at the wall.
// Images alone leave 1.18 of it at 1.49 radii.
TEST(HoleRings, GradedBlocksLeaveTheCylinder) {
  for (const double wall : {1.0, 1.3, 1.5, 1.6, 1.8, 1.999}) {
    TessellationOptions options;
    options.lo = Vec3(-12.0, -12.0, 0.0);
    options.hi = Vec3(12.0, 12.0, 16.0);
    options.holes = {{Vec3(0, 0, 3.0), Vec3(0, 0, 13.0), 1.0}};
    options.size = SizeLaw::power({0.04, 2.0}, {wall, 2.8 * wall});
    const Tessellation cut = tessellate(options);
    const double volume = cylinder_volume(options.holes[0]);
    EXPECT_NEAR(cut.statistics.hole_volume[0], volume, 0.03 * volume) << wall << " radii";
  }
}

TEST(HoleRings, AHoleThatEndsInTheRockHasPlaneEnds) {
  const std::vector<Hole> holes = {{Vec3(0.0, 0.0, 1.6), Vec3(0.0, 0.0, 5.1), 0.25}};
  const TessellationOptions options = with_holes(holes);
  expect_exact_voids(options);
  Vec3 ends = Vec3::Zero();  // the areas that look along the axis [m2]
  for (const Block& block : tessellate(options).blocks) {
    for (std::size_t f = 0; f < block.neighbour.size(); ++f) {
      if (block.neighbour[f] != hole_face(0)) continue;
      const FaceGeometry face = face_geometry(block.shape, static_cast<int>(f));
      ends += face.area * face.normal.cwiseAbs();
      EXPECT_TRUE(std::abs(face.normal.z()) < 1e-9 || std::abs(face.normal.z()) > 1.0 - 1e-9);
    }
  }
  const double section = std::numbers::pi * 0.25 * 0.25;
  EXPECT_NEAR(ends.z(), 2.0 * section, kExact * section);
}

TEST(HoleRings, HolesMayLeanAndBeShort) {
  expect_exact_voids(with_holes({{Vec3(-0.8, -0.5, 1.4), Vec3(0.9, 0.6, 5.3), 0.25}}));
  expect_exact_voids(with_holes({{Vec3(0.0, 0.0, 3.0), Vec3(0.4, 0.0, 3.3), 0.25}}));
  expect_exact_voids(with_holes({{Vec3(-1.5, 0.0, 3.0), Vec3(1.5, 0.0, 3.0), 0.2}}));
}

TEST(HoleRings, HolesKeepTheirOwnVoids) {
  expect_exact_voids(with_holes({{Vec3(-2.0, -1.5, 1.5), Vec3(-2.0, -1.5, 5.0), 0.25},
                                 {Vec3(1.8, 1.6, 1.2), Vec3(2.0, 1.6, 5.5), 0.4}}));
}

TEST(HoleRings, DecksOfOneHoleMayBeNearToEachOther) {
  for (const double stemming : {0.3, 0.7, 1.2, 2.5})
    expect_exact_voids(with_holes({{Vec3(0, 0, 1.0), Vec3(0, 0, 2.5), 0.25},
                                   {Vec3(0, 0, 2.5 + stemming), Vec3(0, 0, 5.8), 0.25}}));
}

TEST(HoleRings, HalfAndQuarterHolesOnWallsHaveTheirShare) {
  for (const double radius : {0.25, 0.5, 0.57, 0.66}) {
    expect_exact_voids(with_holes({{Vec3(-4.0, 0.3, 0.0), Vec3(-4.0, 0.3, 7.0), radius}}), 0.5);
    expect_exact_voids(with_holes({{Vec3(0.3, 4.0, 1.5), Vec3(0.9, 4.0, 5.0), radius}}), 0.5);
    expect_exact_voids(with_holes({{Vec3(-4.0, -4.0, 0.0), Vec3(-4.0, -4.0, 7.0), radius}}), 0.25);
  }
}

TEST(HoleRings, RockThinnerThanAQuarterBlockBeyondAnEndGoesWithTheVoid) {
  const std::vector<Hole> holes = {{Vec3(0, 0, 0.2), Vec3(0, 0, 6.9), 0.25}};
  const double gone = tessellate(with_holes(holes)).statistics.void_volume;
  EXPECT_NEAR(gone, std::numbers::pi * 0.25 * 0.25 * 7.0, 1e-5);
}

TEST(HoleRings, BlocksAroundHaveTheSizeAskedFor) {
  for (const double radius : {0.65, 0.55, 0.5, 0.25}) {
    TessellationOptions options = with_holes({{Vec3(0, 0, 1.6), Vec3(0, 0, 5.1), radius}});
    options.size = SizeLaw::power({0.6, 1.0}, {1.0, 1.6});
    for (const Block& block : tessellate(options).blocks) {
      const auto& behind = block.neighbour;
      if (std::find(behind.begin(), behind.end(), hole_face(0)) == behind.end()) continue;
      const double size = std::cbrt(block.mass.volume) / block.target_size;
      EXPECT_GT(size, 0.8);
      EXPECT_LT(size, 1.35);
    }
  }
}

// The two sides of a plane are cut each for itself; all that looks into the void is on the hole.
TEST(HoleRings, WhereJointPlanesCrossAHoleItsVoidStaysClosed) {
  double widest = 0.0, narrowest = 1.0, smallest = 1.0;
  for (int k = 0; k < 24; ++k) {
    TessellationOptions options = with_holes({{Vec3(0, 0, 1.6), Vec3(0, 0, 5.1), 0.25}});
    const double dip = 0.065 * k, turn = 0.7 * k;
    options.planes = {
        {Vec3(0.04 * (k % 5), 0.03 * (k % 7), 3.3),
         Vec3(std::sin(dip) * std::cos(turn), std::sin(dip) * std::sin(turn), std::cos(dip))}};
    if (k % 2)
      options.planes.push_back({Vec3(0.05, 0.0, 2.9), Vec3(std::cos(turn), std::sin(turn), 0.2)});
    const Tessellation cut = tessellate(options);
    const double volume = cylinder_volume(options.holes[0]), gone = cut.statistics.void_volume;
    for (const Block& block : cut.blocks) test::expect_convex_and_closed(block);
    (void)test::expect_shared_faces(cut.blocks);
    EXPECT_NEAR(cut.statistics.hole_volume[0], gone, 1e-3 * volume) << "scene " << k;
    widest = std::max(widest, gone / volume);
    narrowest = std::min(narrowest, gone / volume);
    for (const Block& block : cut.blocks)
      smallest = std::min(smallest, std::cbrt(block.mass.volume) / block.target_size);
  }
  std::cout << "void over cylinder " << narrowest << " to " << widest
            << ", smallest block over its size " << smallest << '\n';
  EXPECT_GT(narrowest, 0.99);
  EXPECT_LT(widest, 1.01);
  EXPECT_GT(smallest, 0.4);
}

// The area vector of all faces on a closed void is zero; a small face as near to both may be on
// either.
TEST(HoleRings, FacesInAPlaneBetweenDecksAreOnTheNearerOne) {
  for (int k = 0; k < 12; ++k) {
    TessellationOptions options = with_holes(
        {{Vec3(0, 0, 1.0), Vec3(0, 0, 3.0), 0.25}, {Vec3(0, 0, 3.5), Vec3(0, 0, 5.8), 0.25}});
    const double dip = 0.12 * k, turn = 0.7 * k;
    options.planes = {
        {Vec3(0.04 * (k % 5), 0.0, 3.0 + 0.05 * k),
         Vec3(std::sin(dip) * std::cos(turn), std::sin(dip) * std::sin(turn), std::cos(dip))}};
    Vec3 sum[2] = {Vec3::Zero(), Vec3::Zero()};
    for (const Block& block : tessellate(options).blocks) {
      for (std::size_t f = 0; f < block.neighbour.size(); ++f) {
        if (!is_hole_face(block.neighbour[f])) continue;
        const FaceGeometry face = face_geometry(block.shape, static_cast<int>(f));
        sum[hole_of_face(block.neighbour[f])] += face.area * face.normal;
      }
    }
    EXPECT_LT(sum[0].norm(), 0.01) << "scene " << k;
    EXPECT_LT(sum[1].norm(), 0.01) << "scene " << k;
  }
}

TEST(HoleRings, ARingHasSixBlocksAndEightAroundAHoleOnAWall) {
  const auto in_ring = [](const Hole& hole) {
    const HoleRings rings(with_holes({hole}));
    std::vector<double> levels;
    for (const RingSeed& seed : rings.seeds()) levels.push_back(seed.at.z());
    return std::count_if(levels.begin(), levels.end(),
                         [&](double z) { return std::abs(z - levels.front()) < 1e-9; });
  };
  for (const double radius : {0.66, 0.57, 0.4, 1.0 / 6.0}) {
    EXPECT_EQ(in_ring({Vec3(0, 0, 0), Vec3(0, 0, 7), radius}), 6);
    EXPECT_EQ(in_ring({Vec3(-4, 0, 0), Vec3(-4, 0, 7), radius}), 4);    // half of eight
    EXPECT_EQ(in_ring({Vec3(-4, -4, 0), Vec3(-4, -4, 7), radius}), 2);  // a quarter
  }
}

TEST(HoleRings, TheyBeginAtOneAndAHalfRadiiUnlessAskedForLater) {
  TessellationOptions options = with_holes({{Vec3(0, 0, 1.6), Vec3(0, 0, 5.1), 0.66}});
  EXPECT_FALSE(HoleRings(options).seeds().empty());
  options.rings_from = kImagesFail;
  EXPECT_TRUE(HoleRings(options).seeds().empty());
  options.holes[0].radius = 0.5;
  EXPECT_FALSE(HoleRings(options).seeds().empty());
}

TEST(HoleRings, FineBlocksAndOtherCutsHaveNone) {
  TessellationOptions options = with_holes({{Vec3(0, 0, 1.6), Vec3(0, 0, 5.1), 0.68}});
  EXPECT_TRUE(HoleRings(options).seeds().empty());
  options.holes[0].radius = 0.25;
  EXPECT_FALSE(HoleRings(options).seeds().empty());
  options.rings = false;
  EXPECT_TRUE(HoleRings(options).seeds().empty());
}

TEST(HoleRings, RefusesWhatLeavesNoRoom) {
  const auto message = [](std::vector<Hole> holes) {
    return input_error_of([&] { (void)tessellate(with_holes(std::move(holes))); });
  };
  EXPECT_EQ(message({{Vec3(0, 0, 1), Vec3(0, 0, 5), 0.16}}),
            "block tessellation: blocks at the wall of hole 1 must be <= 6 times its crushed-zone "
            "radius 0.16 m, got '1'; take a block_min below 0.96 m, or a wider charge");
  EXPECT_EQ(message({{Vec3(0, 0, 3), Vec3(0, 0, 3.2), 0.25}}),
            "block tessellation: hole 1 must be at least 0.25 of the blocks' 1 m long, got '0.2'; "
            "take a smaller block_min, or a longer charge");
  EXPECT_EQ(message({{Vec3(0, 0, 1), Vec3(0, 0, 5), 0.25}, {Vec3(1, 0, 1), Vec3(1, 0, 5), 0.25}}),
            "block tessellation: holes 1 and 2 are too near to each other for blocks of '1' m "
            "around both; make the blocks smaller or move the holes apart");
}

}  // namespace
}  // namespace muckpile
