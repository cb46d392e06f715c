// SPDX-License-Identifier: GPL-2.0-or-later
// create_blocks a second time, after a run: what exists goes on as if nothing had happened, what is
// new is joined and at rest.
// Scope: a lump that bursts and a second one out of its reach.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "rock_scene.h"

namespace muckpile::test {
namespace {

const std::string kBox = "-4 9 -4 4 -4 4";
constexpr double kTimeStep = 2e-5;  // [s]
enum Joint { kJoints = 1, kBroken = 2, kFracture = 5 };
const std::string kJoint =
    "youngs_modulus 50e9 poisson_ratio 0.25 density 2600 cohesion 4e6 friction_angle 50 tension "
    "2e6";

/// Some 40 blocks about the origin, burst for 30 ms: most joints are broken and some have retired.
void burst(RockScene& scene) {
  scene.command("pair_style muckpile/block youngs_modulus 1e8");
  scene.command("pair_coeff * *");
  scene.cut("-1 1 -1 1 -0.6 0.6",
            "density 2600 size uniform 0.5 block_min 0.5 block_max 0.5 spheres_per_block 4 seed 3");
  scene.command("fix joint all muckpile/joint " + kJoint);
  scene.command("fix ledger all muckpile/ledger");
  const Vec3 spin(4, -6, 20);
  scene.set_motion([&](int, const Vec3& at) {
    return Motion{spin.cross(at) + 0.4 * Vec3(std::sin(3 * at.y()), std::cos(2 * at.z()), 0), spin};
  });
  scene.run(1500, kTimeStep);
}

const std::string kMore =
    "density 2600 size uniform 0.5 block_min 0.5 block_max 0.5 spheres_per_block 4 seed 5";

void cut_more(RockScene& scene) {
  scene.command("region more block 6 8 -1 1 -1 1 units box");
  scene.command("create_blocks more " + kMore);
}

/// Joints of the second rock where it is the only one.
double joints_of_more() {
  RockScene scene(MPI_COMM_WORLD, kBox);
  cut_more(scene);
  scene.command("fix joint all muckpile/joint " + kJoint);
  scene.run(0, kTimeStep);
  return scene.output("joint", kJoints);
}

TEST(SecondCut, CountsTheJointsOfBothRocks) {
  RockScene scene(MPI_COMM_WORLD, kBox);
  burst(scene);
  const double joints = scene.output("joint", kJoints), broken = scene.output("joint", kBroken);
  ASSERT_GT(broken, 0.5 * joints);
  ASSERT_LT(broken, joints);
  cut_more(scene);
  scene.run(0, kTimeStep);
  EXPECT_EQ(scene.output("joint", kJoints), joints + joints_of_more());
  EXPECT_EQ(scene.output("joint", kBroken), broken);
}

TEST(SecondCut, LeavesTheFirstRockAloneAndJoinsTheNewOne) {
  RockScene alone(MPI_COMM_WORLD, kBox), both(MPI_COMM_WORLD, kBox);
  burst(alone);
  burst(both);
  const auto first = both.blocks();
  cut_more(both);
  for (RockScene* scene : {&alone, &both}) scene->run(500, kTimeStep);
  const auto then = alone.blocks(), now = both.blocks();
  ASSERT_GT(now.size(), first.size() + 50);
  for (const auto& [tag, block] : now) {
    if (first.count(tag) == 0) {
      EXPECT_GT(tag, static_cast<int>(first.size()));
      EXPECT_LT(block.velocity.norm(), 1e-9) << tag;  // what rounding of 1e-16 m in joints makes
      continue;
    }
    // Sums of forces may come in another order.
    EXPECT_LT((block.centre - then.at(tag).centre).norm(), 1e-10) << tag;
    EXPECT_LT((block.velocity - then.at(tag).velocity).norm(), 1e-8) << tag;
  }
  EXPECT_EQ(both.output("joint", kBroken), alone.output("joint", kBroken));
  EXPECT_NEAR(both.output("joint", kFracture) / alone.output("joint", kFracture), 1.0, 1e-9);
}

TEST(SecondCut, IsRockUnderTheSameJoint) {
  RockScene scene(MPI_COMM_WORLD, kBox);
  burst(scene);
  const int first = static_cast<int>(scene.blocks().size());
  const double broken = scene.output("joint", kBroken);
  cut_more(scene);
  scene.run(0, kTimeStep);
  // Pulled at one end at a speed that the joints bear: rho cP v = 2600 x 4800 x 0.05 = 0.6 MPa.
  const auto start = scene.blocks();
  double momentum = 0.0, mass = 0.0;
  const auto at_end = [&](const Vec3& at) { return at.x() > 7.5; };
  for (const auto& [tag, block] : start) {
    if (tag <= first) continue;
    mass += block.mass;
    if (at_end(block.centre)) momentum += block.mass * 0.05;
  }
  scene.set_motion([&](int tag, const Vec3& at) {
    return Motion{tag > first && at_end(at) ? Vec3(0.05, 0, 0) : Vec3::Zero(), Vec3::Zero()};
  });
  scene.run(500, kTimeStep);  // 10 ms: the wave has run to and fro ten times
  const double way = momentum / mass * 500 * kTimeStep;
  for (const auto& [tag, block] : scene.blocks()) {
    if (tag <= first) continue;
    // All have gone along; the wave, 0.05 m/s for 2 m / 4800 m/s, makes 0.02 mm of 0.1 mm.
    EXPECT_NEAR((block.centre - start.at(tag).centre).x(), way, 0.3 * way) << tag;
  }
  EXPECT_EQ(scene.output("joint", kBroken), broken);
}

TEST(SecondCut, CreatesNoEnergy) {
  RockScene scene(MPI_COMM_WORLD, kBox);
  scene.command("fix weight all gravity 9.81 vector 0 0 -1");
  burst(scene);
  constexpr int kGravity = 4;  // entry of the ledger
  const double released = scene.output("ledger", kGravity);
  scene.command("region more block 6 8 -1 1 1 3 units box");
  scene.command("create_blocks more " + kMore);
  scene.run(0, kTimeStep);
  EXPECT_NEAR(scene.output("ledger", kGravity), released, 1e-9 * std::abs(released));
  scene.run(500, kTimeStep);
  EXPECT_LT(scene.output("ledger", 0), 0.01);
}

TEST(SecondCut, JointsMayBeReadAndSoftenedBeforeTheNextRun) {
  RockScene scene(MPI_COMM_WORLD, kBox);
  burst(scene);
  cut_more(scene);
  EXPECT_EQ(scene.output("joint", 8), HUGE_VAL);  // not known yet
  scene.command("fix_modify joint soften 0.25");
  EXPECT_EQ(scene.output("joint", 10), 0.25);
  EXPECT_LT(scene.output("joint", 8), 1.0);
  scene.run(10, kTimeStep);
  EXPECT_LT(scene.output("ledger", 0), 0.01);
}

}  // namespace
}  // namespace muckpile::test
