// SPDX-License-Identifier: GPL-2.0-or-later
// sphere_growth and sphere_gap of create_blocks: larger contact spheres, or more of them in large
// blocks, the same bodies, no force at the start.
// Scope: some dozen blocks without joints.
#include <gtest/gtest.h>

#include <map>
#include <string>

#include "rock_scene.h"

namespace muckpile::test {
namespace {

const std::string kRock = "-1 1 -1 1 -0.6 0.6";
const std::string kCut =
    "density 2600 size uniform 0.5 block_min 0.5 block_max 0.5 spheres_per_block 4 seed 3";
constexpr double kGrowth = 1.2;

/// Radius sum less distance of the two spheres of different blocks that overlap most [m].
double deepest_overlap(const std::map<int, SphereNow>& spheres) {
  double deepest = 0.0;
  for (const auto& [a, one] : spheres) {
    for (const auto& [b, two] : spheres) {
      if ((a - 1) / 4 >= (b - 1) / 4) continue;
      deepest = std::max(deepest, one.radius + two.radius - (one.centre - two.centre).norm());
    }
  }
  return deepest;
}

TEST(SphereGrowth, EnlargesTheSpheresAndNothingElse) {
  RockScene inside(MPI_COMM_WORLD, "-3 3 -3 3 -3 3"), grown(MPI_COMM_WORLD, "-3 3 -3 3 -3 3");
  inside.cut(kRock, kCut);
  grown.cut(kRock, kCut + " sphere_growth 1.2");
  const auto small = inside.all_spheres(), large = grown.all_spheres();
  ASSERT_GT(small.size(), 100u);
  ASSERT_EQ(small.size(), large.size());
  for (const auto& [tag, sphere] : large) {
    EXPECT_NEAR(sphere.radius / small.at(tag).radius, kGrowth, 1e-12) << tag;  // rounding
    EXPECT_EQ((sphere.centre - small.at(tag).centre).norm(), 0.0) << tag;
  }
  const auto bodies = inside.blocks();
  for (const auto& [tag, block] : grown.blocks()) {
    EXPECT_EQ(block.mass, bodies.at(tag).mass) << tag;
    EXPECT_EQ((block.inertia - bodies.at(tag).inertia).norm(), 0.0) << tag;
  }
  EXPECT_LT(deepest_overlap(small), 1e-9);  // those inside their blocks touch at most
  EXPECT_GT(deepest_overlap(large), 0.02);
}

TEST(SphereGrowth, OverlapsAtTheStartCarryNoForce) {
  RockScene scene(MPI_COMM_WORLD, "-3 3 -3 3 -3 3");
  scene.command("pair_style muckpile/block youngs_modulus 1e8");
  scene.command("pair_coeff * *");
  scene.cut(kRock, kCut + " sphere_growth 1.2");
  scene.command("fix ledger all muckpile/ledger");
  scene.run(200, 1e-5);
  EXPECT_LT(scene.kinetic_energy(), 1e-20);     // [J]; rounding of the overlaps
  EXPECT_LT(scene.output("ledger", 3), 1e-20);  // elastic energy of sphere contacts
  // Pushed together they do resist: the same spheres, closer than at the start.
  scene.set_motion([](int, const Vec3& at) { return Motion{-0.5 * at, Vec3::Zero()}; });
  scene.run(200, 1e-5);
  EXPECT_GT(scene.output("ledger", 3), 0.01);
}

TEST(SphereGap, GivesLargeBlocksMoreSpheresAndNothingElse) {
  // The same blocks of 0.5 m, smaller ones are allowed: gaps of 0.1 m and of any size.
  const std::string cut =
      "density 2600 size uniform 0.5 block_min 0.1 block_max 0.5 spheres_per_block 4 "
      "sphere_growth 1.2 seed 3";
  RockScene few(MPI_COMM_WORLD, "-3 3 -3 3 -3 3"), more(MPI_COMM_WORLD, "-3 3 -3 3 -3 3");
  more.command("pair_style muckpile/block youngs_modulus 1e8");
  more.command("pair_coeff * *");
  few.cut(kRock, cut);
  more.cut(kRock, cut + " sphere_gap 1");
  EXPECT_GT(more.all_spheres().size(), 1.2 * static_cast<double>(few.all_spheres().size()));
  const auto bodies = few.blocks();
  for (const auto& [tag, block] : more.blocks()) {
    EXPECT_EQ(block.mass, bodies.at(tag).mass) << tag;
    EXPECT_EQ((block.inertia - bodies.at(tag).inertia).norm(), 0.0) << tag;
  }
  more.run(200, 1e-5);
  EXPECT_LT(more.kinetic_energy(), 1e-20);  // [J]; rounding of the overlaps
}

}  // namespace
}  // namespace muckpile::test
