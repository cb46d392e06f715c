// SPDX-License-Identifier: GPL-2.0-or-later
// block_motion: momentum, energy and flight against numbers by hand; before the first run, between
// runs, on blocks that sleep; the energy account stays closed.
// Scope: a few blocks in a run of LIGGGHTS, the same on any number of ranks.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <map>
#include <string>

#include "rock_scene.h"
#include "scratch_folder.h"

namespace muckpile::test {
namespace {

constexpr double kStep = 1e-4;  // [s]
constexpr int kGiven = 14;      // entry of fix muckpile/ledger

/// Cubes of 0.5 m without joints, 8 m of room, no weight unless a test adds it.
RockScene loose_blocks(const std::string& bodies = "multisphere/muckpile") {
  RockScene scene(MPI_COMM_WORLD, "-8 8 -4 4 -4 8", "* 1 1", bodies);
  scene.command("pair_style muckpile/block youngs_modulus 1e7");
  scene.command("pair_coeff * *");
  scene.cut("-1 1 -0.5 0.5 0 1",
            "density 2600 size uniform 0.5 block_min 0.5 block_max 0.5 spheres_per_block 2 seed 4");
  scene.command("region right block 0 8 -4 4 -4 8 units box");
  return scene;
}

Vec3 momentum(const std::map<int, BlockNow>& blocks) {
  Vec3 sum = Vec3::Zero();
  for (const auto& [tag, block] : blocks) sum += block.mass * block.velocity;
  return sum;
}

double mass(const std::map<int, BlockNow>& blocks, double beyond_x = -1e9) {
  double sum = 0.0;
  for (const auto& [tag, block] : blocks) sum += block.centre.x() > beyond_x ? block.mass : 0.0;
  return sum;
}

TEST(BlockMotion, GivesMomentumAndEnergyByHand) {
  RockScene scene = loose_blocks();
  scene.command("block_motion right velocity 3 0 4 spin 0 2 0");
  const auto blocks = scene.blocks();
  const double moved = mass(blocks, 0.0);
  ASSERT_LT(moved, 0.9 * mass(blocks));
  EXPECT_LT((momentum(blocks) - moved * Vec3(3, 0, 4)).norm(), 1e-9 * moved);
  double energy = 0.5 * moved * 25.0;
  for (const auto& [tag, block] : blocks)
    if (block.centre.x() > 0.0) energy += 0.5 * block.inertia(1, 1) * 4.0;
  EXPECT_NEAR(scene.kinetic_energy(), energy, 1e-9 * energy);
}

TEST(BlockMotion, RotationIsThatOfOneRigidBody) {
  RockScene scene = loose_blocks();
  scene.command("variable turn equal 2*1.5");
  scene.command("block_motion all velocity 0 0 1 rotation 0 0 v_turn origin 1 2 0");
  for (const auto& [tag, block] : scene.blocks()) {
    const Vec3 expected = Vec3(0, 0, 1) + Vec3(0, 0, 3).cross(block.centre - Vec3(1, 2, 0));
    EXPECT_LT((block.velocity - expected).norm(), 1e-12) << tag;
    EXPECT_LT((block.spin - Vec3(0, 0, 3)).norm(), 1e-12) << tag;
  }
}

TEST(BlockMotion, PushBesideTheCentreGivesItsMoment) {
  RockScene scene = loose_blocks();
  const auto [tag, block] = *scene.blocks().begin();
  const Vec3 c = block.centre;
  const auto words = [](const Vec3& v) {
    return std::to_string(v.x()) + ' ' + std::to_string(v.y()) + ' ' + std::to_string(v.z());
  };
  scene.command("region one sphere " + words(c) + " 0.01 units box");
  scene.command("block_motion one impulse 50 0 0 at " + words(c + Vec3(0, 0.1, 0)));
  const BlockNow now = scene.blocks().at(tag);
  EXPECT_LT((now.velocity - Vec3(50, 0, 0) / block.mass).norm(), 1e-9);
  EXPECT_LT((now.angular_momentum - Vec3(0, 0, -5.0)).norm(), 1e-4);  // words have six digits
  EXPECT_EQ(momentum(scene.blocks()), Vec3(now.mass * now.velocity));
}

// x = v t, z = w t - g t^2 / 2 to rounding, as leapfrog with a constant force does.
TEST(BlockMotion, ThrownBlocksFlyAsBallisticsSays) {
  RockScene scene = loose_blocks();
  scene.command("fix weight all gravity 9.81 vector 0 0 -1");
  scene.command("fix ledger all muckpile/ledger");
  scene.command("block_motion all velocity 4 0 5");
  const auto start = scene.blocks();
  constexpr int kSteps = 4000;
  const double t = kSteps * kStep;
  scene.run(kSteps, kStep);
  for (const auto& [tag, block] : scene.blocks()) {
    const Vec3 way(4 * t, 0, 5 * t - 0.5 * 9.81 * t * t);
    EXPECT_LT((block.centre - start.at(tag).centre - way).norm(), 1e-9) << tag;
  }
  EXPECT_LT(scene.output("ledger", 0), 1e-9);
}

TEST(BlockMotion, BetweenRunsItIsBooked) {
  for (const std::string bodies : {"multisphere", "multisphere/muckpile"}) {
    RockScene scene = loose_blocks(bodies);
    scene.command("fix weight all gravity 9.81 vector 0 0 -1");
    scene.command("fix ledger all muckpile/ledger");
    scene.run(100, kStep);
    const double before = scene.kinetic_energy();
    scene.command("block_motion right mode add velocity 2 0 6");
    const double given = scene.kinetic_energy() - before;
    ASSERT_GT(given, before);
    scene.run(100, kStep);
    EXPECT_NEAR(scene.output("ledger", kGiven), given, 1e-9 * given);
    EXPECT_LT(scene.output("ledger", 0), 1e-9);
    scene.command("block_motion right velocity 0 0 0");
    scene.command("run 100 pre no");
    EXPECT_LT(scene.output("ledger", 0), 1e-9) << "without set-up";
  }
}

// What was given, and the largest energy seen, go with the restart file.
TEST(BlockMotion, IsBookedAcrossARestart) {
  const ScratchFolder folder("block_motion_restart");
  const std::string file = (folder / "a.restart").string();
  RockScene scene = loose_blocks();
  scene.command("fix ledger all muckpile/ledger");
  scene.run(10, kStep);
  scene.command("block_motion all velocity 5 0 0");
  scene.run(10, kStep);
  const double given = scene.output("ledger", kGiven);
  scene.command("block_motion all velocity 0.1 0 0");
  scene.run(10, kStep);
  scene.command("write_restart " + file);
  RockScene again = RockScene::restarted(MPI_COMM_WORLD, file);
  again.command("pair_style muckpile/block youngs_modulus 1e7");
  again.command("pair_coeff * *");
  again.command("fix ledger all muckpile/ledger");
  again.command("block_motion all velocity 0 0 0");
  again.run(10, kStep);
  EXPECT_GT(given, 0.0);
  EXPECT_LT(std::abs(again.output("ledger", kGiven)), 1e-9 * given);
  EXPECT_LT(again.output("ledger", 0), 1e-9);
}

TEST(BlockMotion, WakesBlocksThatSleep) {
  RockScene scene = loose_blocks();
  scene.command("fix sleep all muckpile/sleep distance 0.01 time 0.005 speed 0.1 every 5");
  scene.run(200, kStep);
  ASSERT_EQ(scene.output("sleep", 0), 1.0);
  scene.command("block_motion all velocity 0 0 1");
  scene.command("run 100 pre no");
  EXPECT_EQ(scene.output("sleep", 0), 0.0);
  for (const auto& [tag, block] : scene.blocks()) EXPECT_NEAR(block.velocity.z(), 1.0, 1e-12);
}

/// Bodies of LIGGGHTS, without an account of energy.
TEST(BlockMotion, MovesBodiesThatCreateBlocksHasNotMade) {
  const ScratchFolder folder("block_motion_bodies");
  std::ofstream(folder / "two.txt") << "0 0 0 0.1\n0.1 0 0 0.1\n";
  RockScene scene(MPI_COMM_WORLD, "-2 6 -2 6 -2 9", "* 1 1", "multisphere/muckpile");
  scene.command(
      "fix two all particletemplate/multisphere 15485863 atom_type 1 density constant 2500 "
      "nspheres "
      "2 ntry 100000 spheres file " +
      (folder / "two.txt").string() + " scale 1.0 type 1");
  scene.command("fix sizes all particledistribution/discrete 32452843 1 two 1.0");
  scene.command("region in block 0 4 0 4 0 4 units box");
  scene.command(
      "fix pour all insert/pack seed 32452867 distributiontemplate sizes insert_every once "
      "overlapcheck yes all_in yes particles_in_region 3 region in");
  scene.run(2, kStep);
  scene.command("block_motion all velocity 1 0 0");
  const auto blocks = scene.blocks();
  ASSERT_EQ(blocks.size(), 3u);
  for (const auto& [tag, block] : blocks) EXPECT_EQ(block.velocity, Vec3::UnitX()) << tag;
}

}  // namespace
}  // namespace muckpile::test
