// SPDX-License-Identifier: GPL-2.0-or-later
// pair_style muckpile/block inside LIGGGHTS: impact, sliding, energy, overlap, several ranks.
// Scope: run with mpirun -np 1 and -np 2; every check holds on any number of ranks.
#include <gtest/gtest.h>
#include <mpi.h>

#include <cmath>
#include <random>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "block_scene.h"

namespace muckpile::testing {
namespace {

// Centre sphere and six arms: 0.3 m from centre to tip, so that blocks meet tip on tip.
std::vector<Ball> jack() {
  std::vector<Ball> balls{{Vec3::Zero(), 0.15}};
  for (int d = 0; d < 3; ++d)
    for (const double side : {-1.0, 1.0}) balls.push_back({side * 0.2 * Vec3::Unit(d), 0.1});
  return balls;
}

// Eight spheres in the corners of a cube of side 0.4 m and one in the middle.
std::vector<Ball> cube() {
  std::vector<Ball> balls{{Vec3::Zero(), 0.2}};
  for (const double x : {-1.0, 1.0})
    for (const double y : {-1.0, 1.0})
      for (const double z : {-1.0, 1.0}) balls.push_back({0.1 * Vec3(x, y, z), 0.1});
  return balls;
}

BlockSpec block(int tag, const Vec3& centre, const Vec3& velocity, std::vector<Ball> balls,
                double mass = 100.0) {
  BlockSpec spec;
  spec.tag = tag;
  spec.centre = centre;
  spec.velocity = velocity;
  spec.mass = mass;
  spec.inertia = Vec3(2.5, 2.5, 2.5) * (mass / 100.0);
  spec.balls = std::move(balls);
  return spec;
}

/// The law, and the steps from one act of the contacts to the next.
class HeadOn : public ::testing::TestWithParam<std::tuple<const char*, int>> {};

TEST_P(HeadOn, ImpactKeepsMomentumAndGivesTheRestitutionAsked) {
  const auto [model, every] = GetParam();
  BlockScene scene(MPI_COMM_WORLD, 2.0, 0.02,
                   std::string("youngs_modulus 5e8 restitution 0.4 model ") + model);
  scene.act_every(every);
  // Meets left of the middle, away from the boundary between two ranks, then crosses it.
  scene.add(
      {block(1, {-0.8, 0, 0}, {3, 0, 0}, jack()), block(2, {0.1, 0, 0}, {-1, 0, 0}, jack(), 50.0)});
  scene.run(40000, 5e-6);
  const auto now = scene.blocks();
  ASSERT_EQ(now.size(), 2u);
  const Vec3 momentum = 100.0 * now.at(1).velocity + 50.0 * now.at(2).velocity;
  EXPECT_NEAR((momentum - Vec3(250, 0, 0)).norm(), 0.0, 1e-10);  // rounding of some 1e3 kicks
  const double parting = now.at(2).velocity.x() - now.at(1).velocity.x();
  // 1 %: the acceptance of the style; contacts that act 85 times in the collision have 1.2 %.
  EXPECT_NEAR(parting / 4.0, 0.4, every == 1 ? 0.004 : 0.008);
  EXPECT_EQ(scene.sum("contacts"), 0.0);
  scene.run(1, 5e-6);  // step 40,001, at which it acts
  EXPECT_EQ(scene.acts_for_several(), every > 1);
  // The dashpots took the difference: 1/2 m* (4^2 - 1.6^2), m* = 100/3 kg. First-order account.
  EXPECT_NEAR(scene.sum("damping_J"), 0.5 * 100.0 / 3.0 * (16.0 - 2.56), every == 1 ? 2.0 : 15.0);
}

INSTANTIATE_TEST_SUITE_P(Models, HeadOn,
                         ::testing::Combine(::testing::Values("hertz", "linear"),
                                            ::testing::Values(1, 16)));

TEST(PairMuckpileBlock, BlockSlidesOnAFixedBlockWithFrictionTimesGravity) {
  BlockScene scene(MPI_COMM_WORLD, 600.0, 0.05,
                   "model hertz youngs_modulus 1e9 friction 0.5 restitution 0.2 "
                   "rolling_friction 0");
  // The floor is one sphere of 200 m: over the path of 0.5 m its slope stays below 0.0013.
  BlockSpec floor = block(1, {0, 0, -200}, Vec3::Zero(), {{Vec3::Zero(), 200.0}}, 1e6);
  floor.fixed = true;
  scene.add({floor, block(2, {-0.25, 0, 0.2}, {2.5, 0, 0}, cube())});
  scene.command("fix weight all gravity 9.81 vector 0 0 -1");
  scene.run(2500, 2e-5);  // sinks in until the feet carry its weight
  const auto start = scene.blocks().at(2);
  scene.run(10000, 2e-5);
  const auto now = scene.blocks().at(2);
  EXPECT_NEAR((start.velocity.x() - now.velocity.x()) / 0.2, 0.5 * 9.81, 0.01 * 0.5 * 9.81);
  EXPECT_GT(now.velocity.x(), 0.5);  // still sliding: the figure above is friction alone
  EXPECT_EQ(scene.blocks().at(1).velocity.norm(), 0.0);
}

std::vector<BlockSpec> crowd(int per_side, double speed, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  std::vector<BlockSpec> blocks;
  int tag = 1;
  for (int i = 0; i < per_side; ++i)
    for (int j = 0; j < per_side; ++j)
      for (int k = 0; k < per_side; ++k) {
        const Vec3 at = 0.62 * (Vec3(i, j, k) - 0.5 * (per_side - 1) * Vec3::Ones());
        const Vec3 jitter(unit(random), unit(random), unit(random));
        blocks.push_back(block(tag++, at + 0.005 * jitter, -speed * at + 0.3 * jitter, jack()));
        blocks.back().spin = 2.0 * jitter;
      }
  return blocks;
}

TEST(PairMuckpileBlock, EnergyOfACollapsingCrowdIsAccountedFor) {
  for (const auto& [model, every] :
       {std::pair("hertz", 1), std::pair("linear", 1), std::pair("hertz", 16)}) {
    BlockScene scene(
        MPI_COMM_WORLD, 6.0, 0.02,
        std::string("youngs_modulus 1e8 restitution 0.5 friction 0.5 rolling_friction 0.1 model ") +
            model);
    scene.act_every(every);
    scene.add(crowd(3, 2.0, 5));
    scene.run(0, 1e-5);
    const double start = scene.energy_account();
    double most_contacts = 0.0;
    for (int part = 0; part < 10; ++part) {
      scene.run(2000, 1e-5);
      most_contacts = std::max(most_contacts, scene.sum("contacts"));
      EXPECT_NEAR(scene.energy_account(), start, 0.01 * start) << model << " part " << part;
    }
    EXPECT_GT(most_contacts, 3.0);
    EXPECT_GT(scene.sum("damping_J"), 0.05 * start);
    EXPECT_GT(scene.sum("friction_J"), 0.01 * start);
  }
}

TEST(PairMuckpileBlock, TwoBlocksThatStartOverlappedStayAtRest) {
  BlockScene scene(MPI_COMM_WORLD, 2.0, 0.02, "youngs_modulus 5e8");
  scene.add({block(1, {-0.29, 0, 0}, Vec3::Zero(), jack()),
             block(2, {0.29, 0, 0}, Vec3::Zero(), jack())});  // 20 mm overlap of two tips
  scene.run(1000, 1e-5);
  EXPECT_EQ(scene.sum("contacts"), 1.0);
  EXPECT_EQ(scene.sum("elastic_J"), 0.0);
  for (const auto& [tag, b] : scene.blocks()) EXPECT_EQ(b.velocity.norm(), 0.0);
}

class Crowd : public ::testing::TestWithParam<int> {};

// The same scene on one rank (each alone) and on all ranks.
TEST_P(Crowd, RanksShareItsCollapseWithoutChangingIt) {
  const std::string contact = "youngs_modulus 1e8 restitution 0.3 friction 0.6";
  BlockScene alone(MPI_COMM_SELF, 6.0, 0.02, contact);
  BlockScene shared(MPI_COMM_WORLD, 6.0, 0.02, contact);
  for (BlockScene* scene : {&alone, &shared}) {
    scene->add(crowd(4, 2.0, 11));
    scene->act_every(GetParam());
  }
  // First contacts: the sums of forces differ in order only, a few 1e-16 each, and have had no
  // time to be amplified by further impacts.
  alone.run(600, 1e-5);
  shared.run(600, 1e-5);
  ASSERT_GT(alone.sum("contacts"), 0.0);
  EXPECT_EQ(alone.sum("contacts"), shared.sum("contacts"));
  const auto early = alone.blocks();
  for (const auto& [tag, b] : shared.blocks()) {
    EXPECT_NEAR((b.centre - early.at(tag).centre).norm(), 0.0, 1e-12) << tag;
    EXPECT_NEAR((b.velocity - early.at(tag).velocity).norm(), 0.0, 1e-10) << tag;
  }
  // Later impacts amplify rounding; the energies still agree: thousands of contacts average out.
  alone.run(20000, 1e-5);
  shared.run(20000, 1e-5);
  EXPECT_NEAR(alone.sum("damping_J"), shared.sum("damping_J"), 0.02 * alone.sum("damping_J"));
  EXPECT_NEAR(alone.energy_account(), shared.energy_account(), 0.01 * alone.energy_account());
  EXPECT_EQ(shared.blocks().size(), 64u);
}

INSTANTIATE_TEST_SUITE_P(Paces, Crowd, ::testing::Values(1, 8));

// Two blocks are pressed together and sheared while they travel over the boundary between two
// ranks (x = 0) and through many rebuilds. As long as the friction spring is not lost on the way
// they turn as one body. No dashpot helps the spring here.
TEST(PairMuckpileBlock, FrictionSpringSurvivesRebuildsAndTheChangeOfRank) {
  const std::string contact = "youngs_modulus 1e7 restitution 1 friction 5 rolling_friction 0";
  BlockScene alone(MPI_COMM_SELF, 3.0, 0.02, contact);
  BlockScene shared(MPI_COMM_WORLD, 3.0, 0.02, contact);
  for (BlockScene* scene : {&alone, &shared}) {
    scene->add({block(1, {-0.65, 0, 0}, {8, 0, 0}, jack()),
                block(2, {-0.65 + 0.6, 0, 0}, {8, 0, 0}, jack())});
    scene->command("group left id 1:7");
    scene->command("group right id 8:14");
    scene->command("fix press_left left addforce 200 0 0");
    scene->command("fix press_right right addforce -200 0 0");
    scene->command("fix shear_left left addforce 0 20 0");
    scene->command("fix shear_right right addforce 0 -20 0");
    scene->run(10000, 1e-5);  // 0.8 m: both blocks and their contact cross
  }
  EXPECT_EQ(alone.sum("contacts"), 1.0);
  EXPECT_EQ(shared.sum("contacts"), 1.0);
  EXPECT_GT(alone.sum("rebuilds"), 10.0);
  const auto a = alone.blocks(), b = shared.blocks();
  // Couple 140 N x 0.6 m = 84 N m on 2 (2.5 + 100 x 0.3^2) = 23 kg m2 for 0.1 s
  const double spin = -84.0 / 23.0 * 0.1, shift = 0.5 * 0.3 * 84.0 / 23.0 * 0.01;  // [rad/s], [m]
  // With springs that start afresh at each rebuild the blocks shift by 7.6 mm and part.
  EXPECT_NEAR(a.at(1).centre.y(), shift, 0.1 * shift);
  EXPECT_NEAR(a.at(2).centre.y(), -shift, 0.1 * shift);
  for (const int tag : {1, 2}) {
    // The spring swings (22 ms, 0.03 rad/s) about the rigid motion; without it nothing would spin.
    EXPECT_NEAR(a.at(tag).spin.z(), spin, 0.1 * std::abs(spin));
    EXPECT_NEAR((a.at(tag).centre - b.at(tag).centre).norm(), 0.0, 1e-12);
    EXPECT_NEAR((a.at(tag).spin - b.at(tag).spin).norm(), 0.0, 1e-10);
  }
}

}  // namespace
}  // namespace muckpile::testing
