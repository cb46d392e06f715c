// SPDX-License-Identifier: GPL-2.0-or-later
// fix muckpile/joint on ranks that share a body: motion, breaking, books, migration.
// Scope: up to some hundred blocks; run with mpirun -np 1, 2 and 4. Scenes on MPI_COMM_SELF are the
// one-rank run that the shared run must equal.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "lump.h"
#include "scratch_folder.h"

namespace muckpile::test {
namespace {

double largest_difference(const RockScene& a, const RockScene& b) {
  const auto one = a.blocks(), two = b.blocks();
  EXPECT_EQ(one.size(), two.size());
  double most = 0.0;
  for (const auto& [tag, block] : one) {
    most = std::max(most, (block.centre - two.at(tag).centre).norm());
    most = std::max(most, (block.velocity - two.at(tag).velocity).norm() / 10.0);
    most = std::max(most, (block.spin - two.at(tag).spin).norm() / 20.0);
  }
  return most;
}

void share_elastic_body(const std::string& cut, const std::string& zones = "") {
  RockScene alone(MPI_COMM_SELF, "-4 4 -4 4 -4 4"),
      shared(MPI_COMM_WORLD, "-4 4 -4 4 -4 4", "* * 1");
  for (RockScene* scene : {&alone, &shared}) {
    make_lump(*scene, "cohesion 1e12 friction_angle 45 tension 1e12" + zones, cut);
    scene->set_motion([](int, const Vec3& at) { return spinning(at, 20.0); });
    scene->run(1000, 1e-5);
  }
  EXPECT_LT(largest_difference(alone, shared),
            1e-9);  // sums in another order; breaking amplifies them
  EXPECT_NEAR(shared.output("joint", elastic) / alone.output("joint", elastic), 1.0, 1e-9);
  EXPECT_NEAR(shared.output("joint", stable_step) / alone.output("joint", stable_step), 1.0, 1e-6);
  EXPECT_LT(shared.output("ledger", 0), 2e-6);  // as of the spinning body
}

TEST(FixMuckpileJoint, RanksShareAnElasticBodyWithoutChangingIt) { share_elastic_body(""); }

TEST(FixMuckpileJoint, RanksShareABodyOfLeaningBlocks) { share_elastic_body(kLeaning); }

TEST(FixMuckpileJoint, RanksShareABodyOfTwoRocks) {
  share_elastic_body(" zone soft 2200 above 0 0 0.1 10 90",
                     " zone soft youngs_modulus 10e9 poisson_ratio 0.35 density 2200");
}

const std::string kStrength = "cohesion 4e6 friction_angle 50 tension 2e6";
// Blocks of 0.5 m hold 17 and 67 J/m2 when they reach their strength.
const std::string kSoftening = kStrength + " fracture_energy_tension 40 fracture_energy_shear 160";
// The lump parts at some 10/s: strengths of 1.4 times those at rest.
const std::string kRate = kStrength + " rate_exponent 0.02";

/// Softer and weaker rock above a border that crosses the ranks.
const std::string kCap = " zone cap 2200 above 0 0 0.1 10 90";
const std::string kOfCap =
    " zone cap youngs_modulus 10e9 poisson_ratio 0.35 density 2200 cohesion 2e6 tension 1e6";

void spin_to_pieces(RockScene& scene, const std::string& strength, const std::string& cut = "") {
  make_lump(scene, strength, cut);
  scene.set_motion([](int, const Vec3& at) { return spinning(at, 20.0); });
  scene.run(1500, 1e-5);
}

/// Broken joints of that lump on one rank.
double broken_alone(const std::string& strength) {
  RockScene alone(MPI_COMM_SELF, "-4 4 -4 4 -4 4");
  spin_to_pieces(alone, strength);
  return alone.output("joint", broken);
}

/// The lump on one rank and on all: the same. Returns how many joints broke.
double broken_on_ranks(const std::string& strength, const std::string& cut = "") {
  RockScene alone(MPI_COMM_SELF, "-4 4 -4 4 -4 4"),
      shared(MPI_COMM_WORLD, "-4 4 -4 4 -4 4", "* * 1");
  for (RockScene* scene : {&alone, &shared}) spin_to_pieces(*scene, strength, cut);
  const double count = alone.output("joint", broken);
  EXPECT_GT(count, 20.0);
  EXPECT_LT(count, alone.output("joint", joints));
  EXPECT_EQ(count, shared.output("joint", broken));
  // Ranks sum forces in another order, and running cracks amplify rounding: 1e-16 m before they run
  // becomes 1e-16 to 8e-7 m, as compilers round. The lump turns by 0.3 rad.
  EXPECT_LT(largest_difference(alone, shared), 1e-5);
  const double taken = alone.output("joint", fracture);
  for (const int n : {friction, damping}) {
    EXPECT_NEAR(shared.output("joint", n), alone.output("joint", n), 1e-6 * taken) << n;
  }
  // Where two neighbours on different ranks crack in one step, the product of the changes of their
  // dilatations is booked a step later.
  const double off = shared.output("joint", fracture) / taken - 1.0;
  std::cout << "fracture energy on ranks: off by " << off << '\n';
  EXPECT_NEAR(off, 0.0, 1e-6);  // measured 6e-13 on 2 and 4 ranks
  EXPECT_NEAR(shared.output("joint", broken_share) / alone.output("joint", broken_share), 1.0,
              1e-9);
  return count;
}

TEST(FixMuckpileJoint, RanksShareABreakingBodyWithoutChangingIt) { broken_on_ranks(kStrength); }

TEST(FixMuckpileJoint, RanksShareABreakingBodyOfLeaningBlocks) {
  broken_on_ranks(kStrength, kLeaning);
}

TEST(FixMuckpileJoint, RanksShareABreakingBodyOfTwoRocks) {
  broken_on_ranks(kStrength + kOfCap, kCap);
}

TEST(FixMuckpileJoint, RanksShareASofteningBodyWithoutChangingIt) {
  EXPECT_NE(broken_on_ranks(kSoftening), broken_alone(kStrength));
}

TEST(FixMuckpileJoint, RanksShareABodyWhoseStrengthGrowsWithItsRate) {
  EXPECT_NE(broken_on_ranks(kRate), broken_alone(kStrength));
}

/// Rows of a table in alphabetic order, without its two first lines, the first of which counts
/// them.
std::vector<std::string> sorted_rows(const std::filesystem::path& table) {
  std::istringstream in(content(table));
  std::vector<std::string> rows;
  for (std::string line; std::getline(in, line);) rows.push_back(line);
  EXPECT_GE(rows.size(), 2u);
  EXPECT_EQ(rows[1], "id,face,broken_share");
  EXPECT_NE(rows[0].find(" rows=" + std::to_string(rows.size() - 2) + ' '), std::string::npos);
  rows.erase(rows.begin(), rows.begin() + 2);
  std::sort(rows.begin(), rows.end());
  return rows;
}

// Each joint is written once, by the rank of its first block, unless it is broken whole.
TEST(FixMuckpileJoint, RanksWriteTheJointsThatHoldOnce) {
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  const ScratchFolder base("joints_that_hold");
  const auto into_alone = base / ("alone" + std::to_string(rank)), into_shared = base / "shared";
  RockScene alone(MPI_COMM_SELF, "-4 4 -4 4 -4 4"),
      shared(MPI_COMM_WORLD, "-4 4 -4 4 -4 4", "* * 1");
  for (const auto& [scene, into] :
       {std::pair(&alone, into_alone), std::pair(&shared, into_shared)}) {
    scene->command("fix snapshots all muckpile/dump every 10000 directory " + into.string());
    spin_to_pieces(*scene, kStrength);
  }
  MPI_Barrier(MPI_COMM_WORLD);
  const std::vector<std::string> rows = sorted_rows(into_alone / "joints.csv");
  EXPECT_EQ(rows, sorted_rows(into_shared / "joints.csv"));
  EXPECT_EQ(std::adjacent_find(rows.begin(), rows.end()), rows.end());
  const auto cracked = std::count_if(rows.begin(), rows.end(),
                                     [](const std::string& row) { return !row.ends_with(",0"); });
  const double whole = alone.output("joint", joints) - static_cast<double>(rows.size());
  EXPECT_GT(whole, 20.0);
  EXPECT_EQ(whole + static_cast<double>(cracked), alone.output("joint", broken));
}

// How slip is taken depends on the volumes of both blocks, also of those of other ranks.
TEST(FixMuckpileJoint, RanksShareALeaningBodyThatSlipsUnderPressure) {
  RockScene alone(MPI_COMM_SELF, "-4 4 -4 4 -4 4"),
      shared(MPI_COMM_WORLD, "-4 4 -4 4 -4 4", "* * 1");
  for (RockScene* scene : {&alone, &shared}) {
    make_lump(*scene, "cohesion 1e5 friction_angle 40 residual_friction_angle 20 tension 1e12",
              kLeaning);
    scene->set_motion([](int, const Vec3& at) {
      return Motion{-20.0 * at + Vec3(0.0, 20.0 * at.z(), 0.0), Vec3::Zero()};
    });
    scene->run(60, 1e-5);
  }
  EXPECT_GT(alone.output("joint", broken), 20.0);
  EXPECT_EQ(alone.output("joint", broken), shared.output("joint", broken));
  const double rubbed = alone.output("joint", friction);
  EXPECT_GT(rubbed, 0.01 * alone.kinetic_energy());
  // Sums in another order; with a wrong volume on the other rank 1e-3 and 7e-5.
  EXPECT_NEAR(shared.output("joint", friction) / rubbed, 1.0, 1e-9);
  EXPECT_LT(largest_difference(alone, shared), 1e-10);
}

TEST(FixMuckpileJoint, RanksShareABodyWhoseWallsCrush) {
  RockScene alone(MPI_COMM_SELF, "-4 4 -4 4 -4 4"),
      shared(MPI_COMM_WORLD, "-4 4 -4 4 -4 4", "* * 1");
  for (RockScene* scene : {&alone, &shared}) {
    make_lump(*scene,
              "cohesion 1e5 friction_angle 40 residual_friction_angle 20 tension 1e5 "
              "wall_strength 10e6");
    scene->set_motion([](int, const Vec3& at) {
      return Motion{-20.0 * at + Vec3(0.0, 20.0 * at.z(), 0.0), Vec3::Zero()};
    });
    scene->run(60, 1e-5);
  }
  const double taken = alone.output("joint", crushing);
  EXPECT_GT(taken, 0.01 * alone.kinetic_energy());
  EXPECT_NEAR(shared.output("joint", crushing) / taken, 1.0, 1e-9);  // sums in another order
  EXPECT_LT(largest_difference(alone, shared), 1e-10);
  // Joints break under ten times what their walls bear, several of a block in one step: 0.012, and
  // 0.006 in a quarter of the step.
  EXPECT_LT(shared.output("ledger", 0), 0.015);
}

/// Friction on one rank and on all.
std::pair<double, double> fly_from_rank_to_rank(const std::string& strength,
                                                const std::string& cut = "") {
  const std::string box = "-4 4 -3 3 -3 3";
  RockScene alone(MPI_COMM_SELF, box), shared(MPI_COMM_WORLD, box);
  int here = 0;
  for (RockScene* scene : {&alone, &shared}) {
    scene->cut("-3 -1.5 -0.6 0.6 -0.6 0.6", uniform(0.5) + cut);
    scene->command(
        "fix joint all muckpile/joint youngs_modulus 50e9 poisson_ratio 0.25 density 2600 "
        "contact_check no " +
        strength);
    here = scene->own_blocks();
    // Strong enough a swing to break some joints at once; the others must outlast the flight.
    scene->set_motion([](int, const Vec3& at) {
      return Motion{
          Vec3(100, 0, 0) + Vec3(0, 0, 5).cross(at) + 0.3 * Vec3(std::sin(5 * at.x()), 0, 0),
          Vec3(0, 0, 5)};
    });
    scene->run(2250, 2e-5);  // 4.5 m: from x = -2.25 to 2.25 m, over every rank border on the way
  }
  int ranks = 1;
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  if (ranks > 1) {
    EXPECT_NE(here, shared.own_blocks());
  }
  EXPECT_EQ(alone.output("joint", broken), shared.output("joint", broken));
  EXPECT_GT(alone.output("joint", broken), 0.0);
  EXPECT_LT(alone.output("joint", broken), 0.8 * alone.output("joint", joints));
  EXPECT_LT(largest_difference(alone, shared),
            1e-9);  // sums in another order; breaking amplifies them
  EXPECT_NEAR(shared.output("joint", elastic) / alone.output("joint", elastic), 1.0, 1e-6);
  return {alone.output("joint", friction), shared.output("joint", friction)};
}

TEST(FixMuckpileJoint, LumpThatFliesFromRankToRankKeepsItsFacets) {
  fly_from_rank_to_rank(kStrength);
}

TEST(FixMuckpileJoint, LeaningBlocksThatFlyFromRankToRankStaySlanted) {
  fly_from_rank_to_rank(kStrength, kLeaning);
}

TEST(FixMuckpileJoint, LumpThatFliesFromRankToRankKeepsWhatItsCracksHold) {
  fly_from_rank_to_rank(kSoftening);
}

// Closure that stays and wear of the roughness: a point that lost either would book it once more.
TEST(FixMuckpileJoint, JointsThatFlyFromRankToRankKeepTheirClosureAndSlip) {
  const auto [alone, shared] = fly_from_rank_to_rank(
      kStrength +
          " joint_class 1 law barton_bandis initial_stiffness 1e10 closure_limit 1e-4 roughness 10 "
          "wall_strength 1e8 residual_friction_angle 30 irrecoverable_closure 0.4 peak_slip 1e-3",
      " joint_plane -2.25 0 0 30 90 1");
  EXPECT_GT(alone, 0.0);
  EXPECT_NEAR(shared / alone, 1.0, 1e-6);
}

}  // namespace
}  // namespace muckpile::test
