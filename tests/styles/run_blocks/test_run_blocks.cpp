// SPDX-License-Identifier: GPL-2.0-or-later
// run_blocks on LIGGGHTS: how far blocks have fallen at the end of a phase, that they come to rest
// on a floor in the next, and which fixes it makes.
// Scope: a few loose blocks; where phases end is in test_blocks_run.cpp.
#include <gtest/gtest.h>

#include <string>

#include "rock_scene.h"
#include "scratch_folder.h"

namespace muckpile::test {
namespace {

constexpr double kGravity = 9.81;  // [m/s2]

/// Blocks 1.5 m wide side by side, their bottom 0.35 m above a floor at z = 0.
RockScene loose_blocks(MPI_Comm comm = MPI_COMM_WORLD) {
  RockScene scene(comm, "-4 4 -4 4 -1 4", "* 1 1", "multisphere/muckpile");
  scene.command(
      "pair_style muckpile/block youngs_modulus 2.5e7 restitution 0.3 friction 0.7 "
      "rolling_friction 1");
  scene.command("pair_coeff * *");
  scene.command("fix m1 all property/global youngsModulus peratomtype 2.5e7");
  scene.command("fix m2 all property/global poissonsRatio peratomtype 0.25");
  scene.command("fix m3 all property/global coefficientRestitution peratomtypepair 1 0.3");
  scene.command("fix m4 all property/global coefficientFriction peratomtypepair 1 0.7");
  scene.command("fix m5 all property/global coefficientRollingFriction peratomtypepair 1 1");
  scene.command(
      "fix floor all wall/gran model hertz tangential history rolling_friction epsd2 primitive "
      "type 1 zplane 0.0 torsionTorque on");
  scene.cut("-0.75 0.75 -0.75 0.75 0.35 1.1",
            "density 2700 size uniform 0.5 block_min 0.5 block_max 0.5 spheres_per_block 4 seed 1");
  scene.command("fix pull all gravity 9.81 vector 0 0 -1");
  return scene;
}

std::string words(const std::string& directory) {
  return " directory " + directory + " density 2700 block_min 0.5 spheres_per_block 4 time_end 6";
}

double mean_height(const RockScene& scene) {
  double sum = 0.0, mass = 0.0;
  for (const auto& [tag, block] : scene.blocks()) {
    sum += block.mass * block.centre.z();
    mass += block.mass;
  }
  return sum / mass;
}

TEST(RunBlocks, EndsAtTheTimeOfThePhase) {
  const ScratchFolder folder("run_blocks_falls");
  RockScene scene = loose_blocks();
  const double height = mean_height(scene);
  scene.command("run_blocks phase fall until 0.25" + words((folder / "").string()));
  scene.command("variable now equal time");
  const double now = scene.variable("now");
  EXPECT_GE(now, 0.25 - 1e-9);
  EXPECT_LT(now, 0.25 + scene.time_step());
  // Leapfrog is exact in free fall; the half step by which its first kick is late adds g t dt / 2.
  const double fallen = 0.5 * kGravity * now * now;
  EXPECT_NEAR(height - mean_height(scene), fallen, 0.6 * kGravity * now * scene.time_step());
  EXPECT_NE(content(folder / "history.csv").find(",fall,"), std::string::npos);
}

TEST(RunBlocks, RunsOnUntilTheRockRests) {
  const ScratchFolder folder("run_blocks_rests");
  RockScene scene = loose_blocks();
  scene.command("run_blocks phase fall until 0.25" + words((folder / "").string()));
  EXPECT_EQ(scene.output("progress", 0), 0.0);
  scene.command("run_blocks phase land" + words((folder / "").string()));
  EXPECT_EQ(scene.output("progress", 0), 1.0);
  EXPECT_LT(scene.output("energy", 0), 0.02);
  const std::string history = content(folder / "history.csv");
  EXPECT_NE(history.find(",fall,"), std::string::npos);
  EXPECT_NE(history.find(",land,"), std::string::npos);
  scene.command("variable now equal time");
  EXPECT_LT(scene.variable("now"), 6.0);
}

// While they fall all blocks move, which only a share above that calls still.
TEST(RunBlocks, TakesTheShareThatMayMoveOfEachCommand) {
  const ScratchFolder folder("run_blocks_share");
  RockScene scene = loose_blocks();
  const std::string fall = "run_blocks phase fall until ", more = words((folder / "").string());
  scene.command(fall + "0.1" + more + " still_share 0.9");
  EXPECT_EQ(scene.output("progress", 0), 0.0);
  scene.command("fix_modify progress still_share 0.5");
  scene.command("run_blocks phase rest" + more + " still_share 1e-6");
  EXPECT_EQ(scene.output("progress", 0), 1.0);
  EXPECT_LT(scene.output("progress", 2), 1e-6);
}

/// The step is that of a collision, whatever the blocks do.
TEST(RunBlocks, ResolvesCollisions) {
  const ScratchFolder folder("run_blocks_step");
  RockScene scene = loose_blocks();
  scene.command("run_blocks phase fall until 0.2" + words((folder / "").string()) +
                " steps_per_contact 800");
  const double fine = scene.time_step();
  scene.command("run_blocks phase fall until 0.22" + words((folder / "").string()) +
                " steps_per_contact 400");
  EXPECT_NEAR(scene.time_step() / fine, 2.0, 0.05);
}

TEST(RunBlocks, DoesTheSameOnAnyNumberOfRanks) {
  const ScratchFolder folder("run_blocks_ranks");
  RockScene all = loose_blocks(), one = loose_blocks(MPI_COMM_SELF);
  all.command("run_blocks until 0.4" + words((folder / "").string()));
  one.command("run_blocks until 0.4" + words(folder.own("alone").string()));
  EXPECT_NEAR(mean_height(all), mean_height(one), 1e-4);
}

}  // namespace
}  // namespace muckpile::test
