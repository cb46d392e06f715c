// SPDX-License-Identifier: GPL-2.0-or-later
// fix muckpile/balance in the engine: even shares, borders that follow, the same physics.
// Scope: some hundred blocks in a box that they fill to a tenth; run with mpirun -np 1, 2 and 4.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <map>
#include <string>

#include "rock_scene.h"
#include "scratch_folder.h"

namespace muckpile::test {
namespace {

const std::string kCut =
    "density 2600 size uniform 0.25 block_min 0.25 block_max 0.25 spheres_per_block 2 seed 5";

int ranks() {
  int count = 1;
  MPI_Comm_size(MPI_COMM_WORLD, &count);
  return count;
}

int most_blocks_of_a_rank(const RockScene& scene) {
  int mine = scene.own_blocks(), most = 0;
  MPI_Allreduce(&mine, &most, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
  return most;
}

TEST(FixMuckpileBalance, ShareBlocksEvenlyFromTheStart) {
  for (const bool balanced : {false, true}) {
    RockScene scene(MPI_COMM_WORLD, "-5 55 -1 2 -1 2");
    if (balanced) scene.command("fix balance all muckpile/balance");
    scene.cut("0 4 0 1 0 1", kCut);
    const auto all = static_cast<double>(scene.blocks().size());
    ASSERT_GT(all, 200.0);
    if (balanced)
      EXPECT_LT(most_blocks_of_a_rank(scene) * ranks() / all, 1.05);
    else
      EXPECT_EQ(most_blocks_of_a_rank(scene), static_cast<int>(all));  // all in the first slab
  }
}

TEST(FixMuckpileBalance, BordersFollowFlyingBlocksOverManyRanksWorthOfBox) {
  RockScene scene(MPI_COMM_WORLD, "-5 55 -1 2 -1 2");
  scene.command("fix balance all muckpile/balance");
  scene.cut("0 4 0 1 0 1", kCut);
  const auto start = scene.blocks();
  const auto speed = [](const Vec3& at) { return 20.0 + 5.0 * at.x(); };  // it spreads as it flies
  scene.set_motion([&](int, const Vec3& at) {
    return Motion{Vec3(speed(at), 0.0, 0.0), Vec3(0.0, 1.0, 0.0)};
  });
  for (int part = 0; part < 20; ++part) {
    scene.run(50, 5e-4);  // up to 1 m, a quarter of the cloud's length: to the next slab of four
    scene.run(0, 5e-4);
    EXPECT_LT(scene.output("balance", 0), 1.15) << "after part " << part;
  }
  const auto now = scene.blocks();
  ASSERT_EQ(now.size(), start.size());
  for (const auto& [tag, block] : start) {
    const Vec3 path(speed(block.centre) * 20 * 50 * 5e-4, 0.0, 0.0);
    EXPECT_LT((now.at(tag).centre - block.centre - path).norm(), 1e-9) << tag;
  }
}

// The box grows from 60 to 155 m as the run starts; parts are shares of the box, so that borders
// would move by ranks.
TEST(FixMuckpileBalance, AMeshThatWidensTheBoxLosesNoBlocks) {
  const ScratchFolder folder("balance_mesh");
  std::ofstream(folder / "floor.stl")
      << "solid floor\nfacet normal 0 0 1\nouter loop\nvertex 0 -0.9 -0.5\n"
         "vertex 150 -0.9 -0.5\nvertex 150 1.9 -0.5\nendloop\nendfacet\nendsolid floor\n";
  RockScene scene(MPI_COMM_WORLD, "-5 55 -1 2 -1 2");
  scene.command("change_box all boundary m f m");
  scene.command("fix balance all muckpile/balance");
  scene.cut("0 4 0 1 0 1", kCut);
  const auto start = scene.blocks();
  scene.command("fix floor all mesh/surface file " + (folder / "floor.stl").string() + " type 1");
  scene.run(1, 1e-6);
  EXPECT_EQ(scene.blocks().size(), start.size());
  EXPECT_LT(scene.output("balance", 0), 1.15);
}

TEST(FixMuckpileBalance, JoinedRockThatBreaksEqualsTheRunOfOneRank) {
  std::array<std::map<int, BlockNow>, 2> result;
  std::array<double, 2> broken{};
  for (const bool shared : {false, true}) {
    RockScene scene(shared ? MPI_COMM_WORLD : MPI_COMM_SELF, "-5 55 -3 4 -3 4");
    if (shared) scene.command("fix balance all muckpile/balance");
    scene.cut("0 2 0 1 0 1", kCut);
    scene.command(
        "fix joint all muckpile/joint youngs_modulus 5e9 poisson_ratio 0.25 density 2600 cohesion "
        "2e5 friction_angle 40 tension 1e5 contact_check no");
    scene.set_motion([](int, const Vec3& at) {
      return Motion{Vec3(2.0 * at.x(), 0.0, 0.5 * at.y()), Vec3::Zero()};
    });
    for (int part = 0; part < 4; ++part) scene.run(50, 2e-5);
    result[shared] = scene.blocks();
    broken[shared] = scene.output("joint", 2);
  }
  EXPECT_GT(broken[0], 10.0);
  EXPECT_EQ(broken[0], broken[1]);
  double worst = 0.0;
  for (const auto& [tag, block] : result[0])
    worst = std::max(worst, (result[1].at(tag).velocity - block.velocity).norm());
  EXPECT_LT(worst, 1e-8);  // [m/s], of about 4; sums in another order
}

// All joints hold and all faces are held: no sphere may act, although grown ones overlap and a rank
// knows many whose block another rank moves.
TEST(FixMuckpileBalance, EnclosedBlocksTouchNobodyOnAnyNumberOfRanks) {
  std::array<std::map<int, BlockNow>, 2> result;
  for (const bool shared : {false, true}) {
    RockScene scene(shared ? MPI_COMM_WORLD : MPI_COMM_SELF, "-5 55 -3 4 -3 4");
    scene.command("pair_style muckpile/block youngs_modulus 1e8");
    scene.command("pair_coeff * *");
    scene.command("fix balance all muckpile/balance");
    scene.command("region everywhere block -9 99 -9 9 -9 9 units box");
    scene.cut("0 2 0 1 0 1", kCut + " sphere_growth 1.3 support fixed everywhere");
    scene.command(
        "fix joint all muckpile/joint youngs_modulus 5e9 poisson_ratio 0.25 density 2600 cohesion "
        "2e9 friction_angle 40 tension 1e9");
    scene.set_motion([](int, const Vec3& at) {
      return Motion{Vec3(at.x() - 1.0, 2.0 * at.y(), at.z()), Vec3::Zero()};
    });
    scene.run(100, 2e-5);
    result[shared] = scene.blocks();
    EXPECT_EQ(scene.output("joint", 2), 0.0);
  }
  double worst = 0.0;
  for (const auto& [tag, block] : result[0])
    worst = std::max(worst, (result[1].at(tag).velocity - block.velocity).norm());
  EXPECT_LT(worst, 1e-9);  // [m/s], of about 1; sums in another order
}

}  // namespace
}  // namespace muckpile::test
