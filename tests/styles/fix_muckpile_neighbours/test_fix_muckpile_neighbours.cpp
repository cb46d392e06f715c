// SPDX-License-Identifier: GPL-2.0-or-later
// fix muckpile/neighbours in the engine: fewer looks for neighbours, no touch missed.
// Scope: loose blocks that rush across borders of ranks and onto walls; run with mpirun -np 1, 2
// and 4.
#include <gtest/gtest.h>

#include <array>
#include <fstream>
#include <map>
#include <string>

#include "args/numbers.h"
#include "rock_scene.h"
#include "scratch_folder.h"

namespace muckpile::test {
namespace {

const std::string kCut =
    "density 2600 size uniform 0.5 block_min 0.5 block_max 0.5 spheres_per_block 3 seed 5";
constexpr double kTimeStep = 1e-4;  // [s]

RockScene scene_of(bool alone, const std::string& border_skin, const std::string& box) {
  RockScene scene(alone ? MPI_COMM_SELF : MPI_COMM_WORLD, box, "* 1 1", "multisphere/muckpile");
  scene.command("communicate single cutoff 0.0 vel yes");
  scene.command("neighbor 0.2 bin");
  scene.command("pair_style muckpile/block youngs_modulus 2e7");
  scene.command("pair_coeff * *");
  if (!border_skin.empty())
    scene.command("fix near all muckpile/neighbours border_skin " + border_skin);
  return scene;
}

double worst_difference(const std::map<int, BlockNow>& a, const std::map<int, BlockNow>& b) {
  EXPECT_EQ(a.size(), b.size());
  double worst = 0.0;
  for (const auto& [tag, block] : a)
    worst = std::max(worst, (b.at(tag).velocity - block.velocity).norm());
  return worst;
}

/// Two blocks of one sphere each, 1 m apart, fly into each other near the border of two ranks at
/// 3.85 m, along the axis that ranks share.
std::map<int, BlockNow> after_clash(bool alone, const std::string& border_skin, double shift) {
  RockScene scene = scene_of(alone, border_skin, "-4 11.7 -4 5 -4 5");
  for (const double x : {2.5, 4.0}) {
    const std::string rock = x < 3.0 ? "left" : "right";
    scene.command("region " + rock + " block " + number_text(x + shift) + ' ' +
                  number_text(x + shift + 0.5) + " 0 0.5 0 0.5 units box");
    scene.command("create_blocks " + rock +
                  " density 2600 size uniform 0.5 block_min 0.5 block_max 0.5 spheres_per_block 1");
  }
  const double middle = 3.5 + shift;
  scene.set_motion([&](int, const Vec3& at) {
    return Motion{Vec3(at.x() < middle ? 15.0 : -15.0, 0.0, 0.0), Vec3::Zero()};
  });
  scene.run(420, kTimeStep);  // they meet after 333 steps
  return scene.blocks();
}

// 1e-8 m/s: rounding, in another order of the sums; a touch that is found a step late differs by
// some m/s.
TEST(FixMuckpileNeighbours, BlocksThatRushAcrossBordersMeetAsOnOneRank) {
  for (double shift = 0.0; shift < 0.75; shift += 0.05) {
    const auto expected = after_clash(true, "", shift);
    ASSERT_EQ(expected.size(), 2u);
    for (const auto& [tag, block] : expected) EXPECT_LT(block.velocity.norm(), 12.0) << shift;
    for (const std::string border_skin : {"0.2", "0.1"})
      EXPECT_LT(worst_difference(expected, after_clash(false, border_skin, shift)), 1e-8)
          << border_skin << ' ' << shift;
  }
}

/// A cloud falls onto a plane and a mesh, along axes that no ranks share.
std::map<int, BlockNow> after_landing(const std::string& border_skin, double* looks) {
  const ScratchFolder folder("neighbours_mesh");
  std::ofstream(folder / "floor.stl")
      << "solid floor\nfacet normal 0 0 1\nouter loop\nvertex -3.9 -3.9 -0.6\n"
         "vertex 11.9 -3.9 -0.6\nvertex 11.9 4.9 -0.6\nendloop\nendfacet\n"
         "facet normal 0 0 1\nouter loop\nvertex -3.9 -3.9 -0.6\n"
         "vertex 11.9 4.9 -0.6\nvertex -3.9 4.9 -0.6\nendloop\nendfacet\nendsolid floor\n";
  RockScene scene = scene_of(false, border_skin, "-4 12 -4 5 -4 5");
  scene.command("fix m1 all property/global youngsModulus peratomtype 2e7");
  scene.command("fix m2 all property/global poissonsRatio peratomtype 0.25");
  scene.command("fix m3 all property/global coefficientRestitution peratomtypepair 1 0.5");
  scene.command("fix m4 all property/global coefficientFriction peratomtypepair 1 0.5");
  scene.cut("0 4 0 1 0 1", kCut);
  scene.command("fix floor all mesh/surface file " + (folder / "floor.stl").string() + " type 1");
  scene.command(
      "fix ground all wall/gran model hertz tangential history mesh n_meshes 1 meshes floor");
  scene.command(
      "fix side all wall/gran model hertz tangential history primitive type 1 yplane -0.7");
  scene.set_motion([](int, const Vec3& at) {
    return Motion{Vec3(0.5 * at.x(), -12.0, -12.0), Vec3::Zero()};
  });
  scene.run(1000, kTimeStep);  // 1.2 m: the highest land, too
  if (looks != nullptr) *looks = scene.output("near", 0);
  return scene.blocks();
}

TEST(FixMuckpileNeighbours, WallsMissNoSphere) {
  const auto expected = after_landing("", nullptr);
  for (const auto& [tag, block] : expected) EXPECT_GT(block.centre.z(), -0.7) << tag;
  double whole = 0.0, half = 0.0;
  EXPECT_LT(worst_difference(expected, after_landing("0.2", &whole)), 1e-8);
  EXPECT_LT(worst_difference(expected, after_landing("0.1", &half)), 1e-8);
  EXPECT_GT(whole, 5.0);
  EXPECT_NEAR(half, whole, 2.0);  // hardly any way goes across a border
}

// 15 m/s over 0.02 s is 0.3 m: three looks where a sphere may move by half the skin of 0.2 m, six
// where it may move across borders by half of 0.1 m, and the one before the first step is
// LIGGGHTS'.
TEST(FixMuckpileNeighbours, LooksAsOftenAsTheWayAlongEachAxisNeeds) {
  int ranks = 1;
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  const auto looks = [](const Vec3& velocity) {
    RockScene scene = scene_of(false, "0.1", "-4 12 -4 5 -4 5");
    scene.cut("0 4 0 1 0 1", kCut);
    scene.set_motion([&](int, const Vec3&) { return Motion{velocity, Vec3::Zero()}; });
    scene.run(201, kTimeStep);
    return scene.output("near", 0);
  };
  const double along = looks(Vec3(0.0, 15.0, 0.0)), across = looks(Vec3(15.0, 0.0, 0.0));
  EXPECT_NEAR(along, 2.0, 1.0);
  EXPECT_NEAR(across, ranks > 1 ? 5.0 : along, 1.0);
}

TEST(FixMuckpileNeighbours, UnfixGivesTheCheckBackToLiggghts) {
  RockScene scene = scene_of(false, "0.1", "-4 12 -4 5 -4 5");
  scene.cut("0 4 0 1 0 1", kCut);
  scene.run(1, kTimeStep);
  scene.command("unfix near");
  scene.set_motion([](int, const Vec3&) { return Motion{Vec3(0.0, 30.0, 0.0), Vec3::Zero()}; });
  scene.run(100, kTimeStep);  // 0.3 m
  scene.command("fix near all muckpile/neighbours border_skin 0.2");
  EXPECT_GE(scene.output("near", 0), 2.0);
}

}  // namespace
}  // namespace muckpile::test
