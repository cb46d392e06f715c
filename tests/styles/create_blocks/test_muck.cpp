// SPDX-License-Identifier: GPL-2.0-or-later
// create_blocks ... muck: rock that flies into muck at rest shares its momentum with it, the same
// on any number of ranks and from a restart file; muck that nothing hits stays at rest.
// Scope: a lump of rock and a lump of muck of an earlier run, without gravity.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <map>
#include <string>

#include "rock_scene.h"
#include "scratch_folder.h"

namespace muckpile::test {
namespace {

const std::string kBox = "-4 9 -2 2 -2 2";
const std::string kSizes =
    "density 2600 size uniform 0.5 block_min 0.5 block_max 0.5 spheres_per_block 4 seed 3 ";
constexpr double kTimeStep = 2e-5;  // [s]
constexpr double kSpeed = 5.0;      // of the rock [m/s]

/// The muck's run: a lump of 1 m, of which nothing has moved.
void save(MPI_Comm comm, const std::string& folder) {
  RockScene scene(comm, kBox, "* 1 1", "multisphere/muckpile");
  scene.cut("0.1 1.1 -0.5 0.5 -0.5 0.5", kSizes + "file " + folder + "/blocks.vtk");
  scene.command("fix snapshots all muckpile/dump every 100 directory " + folder);
  scene.run(0, kTimeStep);
}

RockScene rock_before_muck(MPI_Comm comm, const std::string& folder) {
  save(comm, folder);
  MPI_Barrier(comm);
  RockScene scene(comm, kBox, "* 1 1", "multisphere/muckpile");
  scene.command("pair_style muckpile/block youngs_modulus 1e8 restitution 0.3");
  scene.command("pair_coeff * *");
  scene.cut("-1 0 -0.5 0.5 -0.5 0.5", kSizes + "muck " + folder + " 0 0 0 all");
  scene.command(
      "fix joint all muckpile/joint youngs_modulus 50e9 poisson_ratio 0.25 density 2600 cohesion "
      "4e9 friction_angle 50 tension 2e9");
  scene.command("fix ledger all muckpile/ledger");
  return scene;
}

struct Lumps {
  double rock = 0.0, muck = 0.0;  // [kg] or [kg m/s]
  [[nodiscard]] double all() const { return rock + muck; }
};

template <class Value>
Lumps sum(const std::map<int, BlockNow>& blocks, const Value& value) {
  Lumps lumps;
  for (const auto& [tag, block] : blocks)
    (tag <= static_cast<int>(blocks.size()) / 2 ? lumps.rock : lumps.muck) += value(block);
  return lumps;
}
Lumps masses(const RockScene& scene) {
  return sum(scene.blocks(), [](const BlockNow& b) { return b.mass; });
}
Lumps momenta(const RockScene& scene) {
  return sum(scene.blocks(), [](const BlockNow& b) { return b.mass * b.velocity.x(); });
}

void throw_rock(RockScene& scene) {
  const int rock = static_cast<int>(scene.blocks().size()) / 2;
  scene.set_motion([rock](int tag, const Vec3&) {
    return Motion{tag <= rock ? Vec3(kSpeed, 0, 0) : Vec3::Zero(), Vec3::Zero()};
  });
}

TEST(Muck, TakesMomentumFromRockThatHitsIt) {
  const ScratchFolder folder("muck_momentum");
  RockScene scene = rock_before_muck(MPI_COMM_WORLD, (folder / "saved").string());
  const Lumps mass = masses(scene);
  EXPECT_NEAR(mass.muck, 2600.0, 1e-6);  // 1 m3
  throw_rock(scene);
  const double given = momenta(scene).all();
  EXPECT_NEAR(given, kSpeed * mass.rock, 1e-9 * given);
  scene.run(4000, kTimeStep);  // 80 ms: rock that nothing stops has gone 0.4 m
  const Lumps after = momenta(scene);
  std::printf("rock %.3f, muck %.3f of the momentum; sum %.2e off\n", after.rock / given,
              after.muck / given, after.all() / given - 1.0);
  EXPECT_NEAR(after.all(), given, 1e-9 * given);
  // Bodies of equal mass m1, m2: the rock keeps at most m1 / (m1 + m2), where they stay together,
  // and at least (1 - e) / 2, the collision of two whole bodies with the restitution e = 0.3.
  EXPECT_LT(after.rock / given, 0.5);
  EXPECT_GT(after.rock / given, 0.35);
  constexpr int kBalance = 0;
  EXPECT_LT(scene.output("ledger", kBalance), 0.02);
}

TEST(Muck, StaysAtRestWhereNothingHitsIt) {
  const ScratchFolder folder("muck_rest");
  RockScene scene = rock_before_muck(MPI_COMM_WORLD, (folder / "saved").string());
  scene.run(500, kTimeStep);
  for (const auto& [tag, block] : scene.blocks()) EXPECT_LT(block.velocity.norm(), 1e-9) << tag;
}

/// Speeds [m/s] after the rock has hit the muck.
std::map<int, BlockNow> hit(MPI_Comm comm, const std::string& folder) {
  RockScene scene = rock_before_muck(comm, folder);
  throw_rock(scene);
  scene.run(2000, kTimeStep);
  return scene.blocks();
}

TEST(Muck, IsTheSameOnAnyNumberOfRanks) {
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  const ScratchFolder folder("muck_ranks");
  const auto alone = hit(MPI_COMM_SELF, (folder / ("alone" + std::to_string(rank))).string()),
             shared = hit(MPI_COMM_WORLD, (folder / "shared").string());
  ASSERT_EQ(alone.size(), shared.size());
  for (const auto& [tag, block] : shared) {
    EXPECT_LT((block.centre - alone.at(tag).centre).norm(), 1e-7) << tag;
    EXPECT_NEAR(block.mass, alone.at(tag).mass, 1e-9 * block.mass) << tag;
  }
}

TEST(Muck, GoesOnFromARestartFile) {
  const ScratchFolder folder("muck_restart");
  const std::string file = (folder / "file.restart").string();
  RockScene whole = rock_before_muck(MPI_COMM_WORLD, (folder / "saved").string());
  throw_rock(whole);
  whole.run(1000, kTimeStep);
  whole.command("write_restart " + file);
  whole.run(1000, kTimeStep);
  const auto expected = whole.blocks();
  RockScene again = RockScene::restarted(MPI_COMM_WORLD, file);
  again.command("pair_style muckpile/block youngs_modulus 1e8 restitution 0.3");
  again.command("pair_coeff * *");
  again.command(
      "fix joint all muckpile/joint youngs_modulus 50e9 poisson_ratio 0.25 density 2600 cohesion "
      "4e9 friction_angle 50 tension 2e9");
  again.command("fix ledger all muckpile/ledger");
  again.run(1000, kTimeStep);
  ASSERT_EQ(again.blocks().size(), expected.size());
  for (const auto& [tag, block] : again.blocks()) {
    EXPECT_LT((block.centre - expected.at(tag).centre).norm(), 1e-6) << tag;
    EXPECT_NEAR(block.mass, expected.at(tag).mass, 1e-12 * block.mass);
  }
}

}  // namespace
}  // namespace muckpile::test
