// SPDX-License-Identifier: GPL-2.0-or-later
// fix muckpile/sleep in the engine: what rests stays, what is hit wakes, the books close.
// Scope: some 30 loose blocks in a bin; one of them is thrown up and comes down on the others.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>
#include <string>

#include "rock_scene.h"
#include "scratch_folder.h"

namespace muckpile::test {
namespace {

constexpr double kStep = 1e-4;      // [s]
constexpr double kDistance = 2e-3;  // [m]
constexpr double kThrown = 6.0;     // [m/s] up

const std::string kSleep = "distance 2e-3 time 0.1";

/// Entries of fix muckpile/ledger, numbered from 1.
enum Entry { gravity = 4, laid_to_rest = 13 };

/// Blocks of 0.4 m that no joint holds; the topmost one flies up for 1.2 s.
class LooseBlocks : public RockScene {
 public:
  /// `sleep`: the words of fix muckpile/sleep, none without it.
  LooseBlocks(MPI_Comm comm, const std::string& sleep)
      : RockScene(comm, "-3 3 -3 3 -1 4", "* 1 1", "multisphere/muckpile") {
    add_contacts();
    cut("-0.6 0.6 -0.6 0.6 0 1.2",
        "density 2600 size uniform 0.4 block_min 0.4 block_max 0.4 spheres_per_block 5 seed 3");
    add_joints_and_books(sleep);
    set_motion([](int, const Vec3& at) {
      const bool top = at.z() > 0.9 && at.head<2>().norm() < 0.3;
      return Motion{Vec3(0.0, 0.0, top ? kThrown : 0.0), Vec3::Zero()};
    });
  }
  /// Goes on from a file written at `time`.
  LooseBlocks(MPI_Comm comm, const std::string& file, double time, const std::string& sleep)
      : RockScene(restarted(comm, file)), time_(time) {
    add_contacts();
    add_joints_and_books(sleep);
  }
  void run_to(double time) {
    const int more = static_cast<int>(std::round((time - time_) / kStep));
    run(more, kStep);
    time_ = time;
  }
  [[nodiscard]] double resting_share() const { return output("sleep", 0); }

 private:
  void add_contacts() {
    for (const char* line :
         {"fix m1 all property/global youngsModulus peratomtype 1e7",
          "fix m2 all property/global poissonsRatio peratomtype 0.25",
          "fix m3 all property/global coefficientRestitution peratomtypepair 1 0.3",
          "fix m4 all property/global coefficientFriction peratomtypepair 1 0.6",
          "pair_style muckpile/block youngs_modulus 1e7 restitution 0.3 friction 0.6 "
          "rolling_friction 0.5",
          "pair_coeff * *",
          "fix floor all wall/gran model hertz tangential history primitive type 1 zplane 0.0",
          "fix weight all gravity 9.81 vector 0 0 -1"})
      command(line);
    for (const char* side : {"xplane -0.6", "xplane 0.6", "yplane -0.6", "yplane 0.6"})
      command("fix wall" + std::to_string(walls_++) +
              " all wall/gran model hertz tangential history primitive type 1 " + side);
  }
  void add_joints_and_books(const std::string& sleep) {
    command(
        "fix joint all muckpile/joint youngs_modulus 2e7 poisson_ratio 0.25 density 2600 cohesion "
        "0 friction_angle 35 tension 0 contact_damping 0.3");
    if (!sleep.empty()) command("fix sleep all muckpile/sleep " + sleep);
    command("fix ledger all muckpile/ledger");
  }
  double time_ = 0.0;
  int walls_ = 0;
};

double farthest_apart(const std::map<int, BlockNow>& a, const std::map<int, BlockNow>& b) {
  double worst = 0.0;
  for (const auto& [tag, block] : a)
    worst = std::max(worst, (block.centre - b.at(tag).centre).norm());
  return worst;
}

TEST(FixMuckpileSleep, WhatRestsIsHeldUntilItIsHit) {
  LooseBlocks scene(MPI_COMM_WORLD, kSleep);
  ASSERT_GT(scene.blocks().size(), 20U);
  scene.run_to(0.9);
  EXPECT_GT(scene.resting_share(), 0.8);
  const auto before = scene.blocks();
  scene.run_to(1.0);
  const auto resting = scene.blocks();
  int held = 0;
  for (const auto& [tag, block] : resting) held += block.centre == before.at(tag).centre ? 1 : 0;
  EXPECT_GT(held, 0.8 * static_cast<double>(resting.size()));
  scene.run_to(1.3);  // it came down at some 6 m/s
  EXPECT_LT(scene.resting_share(), 0.5);
  EXPECT_GT(farthest_apart(resting, scene.blocks()), 0.01);
  scene.run_to(2.5);
  EXPECT_GT(scene.resting_share(), 0.95) << "all come to rest again";
}

TEST(FixMuckpileSleep, WhatRestsStillRestsAfterARestart) {
  const ScratchFolder folder("restart");
  const std::string file = folder / "loose.restart";
  LooseBlocks went_on(MPI_COMM_WORLD, kSleep);
  went_on.run_to(0.9);
  const double share = went_on.resting_share(), taken = went_on.output("ledger", laid_to_rest);
  EXPECT_GT(share, 0.8);
  went_on.command("write_restart " + file);
  LooseBlocks restarted(MPI_COMM_WORLD, file, 0.9, kSleep);
  restarted.run_to(0.9);
  EXPECT_EQ(restarted.resting_share(), share);
  EXPECT_NEAR(restarted.output("ledger", laid_to_rest), taken, 1e-12 * taken);
  went_on.run_to(1.0);
  restarted.run_to(1.0);
  const double apart = farthest_apart(went_on.blocks(), restarted.blocks());
  std::cout << "0.1 s later: " << apart << " m apart\n";
  EXPECT_LT(apart, 1e-3 * kDistance);
  EXPECT_EQ(restarted.resting_share(), went_on.resting_share());
  went_on.run_to(2.5);
  restarted.run_to(2.5);
  EXPECT_LT(restarted.output("ledger", 0), 0.01) << "books of both runs together";
  EXPECT_GT(restarted.resting_share(), 0.95);
}

TEST(FixMuckpileSleep, BlocksGoWhereTheyGoWithoutIt) {
  LooseBlocks off(MPI_COMM_SELF, ""), on(MPI_COMM_SELF, kSleep);
  off.run_to(1.1);
  on.run_to(1.1);
  const double before = farthest_apart(on.blocks(), off.blocks());
  EXPECT_LT(before, 2.0 * kDistance) << "up to the blow";
  std::cout << "farthest apart before the blow: " << before << " m\n";
  off.run_to(1.3);
  on.run_to(1.3);
  const double after = farthest_apart(on.blocks(), off.blocks());
  EXPECT_LT(after, 0.05) << "the blow wakes what it hits in time";
  std::cout << "after it: " << after << " m\n";
  off.run_to(2.5);
  on.run_to(2.5);
  const auto height = [](const RockScene& scene) {
    double sum = 0.0;
    for (const auto& [tag, block] : scene.blocks()) sum += block.centre.z();
    return sum / static_cast<double>(scene.blocks().size());
  };
  EXPECT_NEAR(height(on), height(off), 0.01 * height(off));
}

TEST(FixMuckpileSleep, EnergyTakenIsBooked) {
  LooseBlocks scene(MPI_COMM_WORLD, kSleep);
  for (const double time : {0.5, 1.0, 1.5, 2.5}) {
    scene.run_to(time);
    EXPECT_LT(scene.output("ledger", 0), 0.01) << "at " << time << " s";
  }
  EXPECT_GT(scene.output("ledger", laid_to_rest), 0.0);
  EXPECT_EQ(scene.output("ledger", laid_to_rest), scene.output("sleep", 2));
  EXPECT_LT(scene.output("ledger", laid_to_rest), 1e-3 * std::abs(scene.output("ledger", gravity)));
}

// So careless that it stops the flying block: most of the energy is taken at once.
TEST(FixMuckpileSleep, EnergyTakenFromAFlyingBlockIsBooked) {
  LooseBlocks scene(MPI_COMM_WORLD, "distance 0.5 time 1e-3 speed 100 every 1");
  scene.run_to(0.01);
  double start = 0.0;
  for (const auto& [tag, block] : scene.blocks()) {
    if (block.centre.z() > 0.9) start = std::max(start, 0.5 * block.mass * kThrown * kThrown);
  }
  EXPECT_GT(scene.output("ledger", laid_to_rest), 0.5 * start);
  EXPECT_LT(scene.output("ledger", 0), 0.02);
}

// A fix of LIGGGHTS at the end of the step makes fix multisphere set full-step velocities.
TEST(FixMuckpileSleep, SpheresOfRestingBlocksStandStill) {
  LooseBlocks scene(MPI_COMM_WORLD, kSleep);
  scene.command("variable now equal time");
  scene.command("fix say all print 100 '${now}' screen no");
  scene.run_to(0.9);
  ASSERT_GT(scene.resting_share(), 0.5);
  double still = 0.0;
  const auto spheres = scene.all_spheres();
  for (const auto& [tag, sphere] : spheres) still += sphere.velocity.norm() == 0.0 ? 1.0 : 0.0;
  EXPECT_NEAR(still / static_cast<double>(spheres.size()), scene.resting_share(), 1e-9);
}

int sunk_blocks(const std::map<int, BlockNow>& before, const std::map<int, BlockNow>& now) {
  int sunk = 0;
  for (const auto& [tag, block] : now)
    sunk += block.centre.z() < before.at(tag).centre.z() - 0.02 ? 1 : 0;
  return sunk;
}

TEST(FixMuckpileSleep, UnfixWakesAll) {
  LooseBlocks scene(MPI_COMM_WORLD, kSleep);
  scene.run_to(0.9);
  ASSERT_GT(scene.resting_share(), 0.8);
  const auto before = scene.blocks();
  scene.command("unfix sleep");
  scene.run_to(1.1);
  EXPECT_LE(sunk_blocks(before, scene.blocks()), 1)
      << "all but the flying block are still carried by what is below them";
}

TEST(FixMuckpileSleep, WokenBlocksAreCarriedInARunWithoutSetUp) {
  LooseBlocks scene(MPI_COMM_WORLD, kSleep);
  scene.run_to(0.9);
  ASSERT_GT(scene.resting_share(), 0.8);
  const auto before = scene.blocks();
  scene.command("fix_modify sleep wake");
  scene.command("run " + std::to_string(static_cast<int>(0.1 / kStep)) + " pre no");
  EXPECT_LE(sunk_blocks(before, scene.blocks()), 1);
}

TEST(FixMuckpileSleep, RanksAgree) {
  LooseBlocks alone(MPI_COMM_SELF, kSleep), shared(MPI_COMM_WORLD, kSleep);
  for (const double time : {0.6, 1.1}) {
    alone.run_to(time);
    shared.run_to(time);
    EXPECT_EQ(alone.output("sleep", 1), shared.output("sleep", 1)) << "at " << time << " s";
    EXPECT_LT(farthest_apart(alone.blocks(), shared.blocks()), 1e-6) << "at " << time << " s";
  }
}

TEST(FixMuckpileSleep, WakesOnCommand) {
  LooseBlocks scene(MPI_COMM_WORLD, kSleep);
  scene.run_to(0.9);
  ASSERT_GT(scene.resting_share(), 0.8);
  scene.command("unfix floor");
  scene.command("fix_modify sleep wake");
  EXPECT_EQ(scene.resting_share(), 0.0);
  const auto before = scene.blocks();
  scene.run_to(1.0);
  int falling = 0;
  for (const auto& [tag, block] : scene.blocks()) {
    const double fallen = before.at(tag).centre.z() - block.centre.z();
    falling += std::abs(fallen - 0.5 * 9.81 * 0.1 * 0.1) < 0.01 ? 1 : 0;
  }
  EXPECT_GT(falling, 10);
}

TEST(FixMuckpileSleep, EnergyTakenStaysBookedAfterIt) {
  LooseBlocks scene(MPI_COMM_WORLD, "distance 0.5 time 1e-3 speed 100 every 1");
  scene.run_to(0.01);
  const double taken = scene.output("ledger", laid_to_rest);
  ASSERT_GT(taken, 0.0);
  scene.command("unfix sleep");
  EXPECT_EQ(scene.output("ledger", laid_to_rest), taken);
  scene.run_to(0.02);
  EXPECT_EQ(scene.output("ledger", laid_to_rest), taken);
  scene.command("fix sleep all muckpile/sleep " + kSleep);
  scene.run_to(0.03);
  EXPECT_EQ(scene.output("ledger", laid_to_rest), taken + scene.output("sleep", 2));
  EXPECT_LT(scene.output("ledger", 0), 0.02);
}

TEST(FixMuckpileSleep, EnergyTakenStaysBookedWhereAnotherComesLateAfterARestart) {
  const ScratchFolder folder("restart");
  const std::string file = folder / "loose.restart";
  LooseBlocks went_on(MPI_COMM_WORLD, "distance 0.5 time 1e-3 speed 100 every 1");
  went_on.run_to(0.01);
  const double taken = went_on.output("ledger", laid_to_rest);
  ASSERT_GT(taken, 0.0);
  went_on.command("write_restart " + file);
  LooseBlocks restarted(MPI_COMM_WORLD, file, 0.01, "");
  restarted.run_to(0.02);
  EXPECT_NEAR(restarted.output("ledger", laid_to_rest), taken, 1e-12 * taken);
  restarted.command("fix sleep all muckpile/sleep " + kSleep);
  restarted.run_to(0.03);
  EXPECT_NEAR(restarted.output("ledger", laid_to_rest), taken + restarted.output("sleep", 2),
              1e-12 * taken);
  EXPECT_LT(restarted.output("ledger", 0), 0.02);
}

}  // namespace
}  // namespace muckpile::test
