// SPDX-License-Identifier: GPL-2.0-or-later
// fix muckpile/joint in the engine: strength, vibration, momentum, energy, migration, softening.
// Scope: up to some hundred blocks; run with mpirun -np 1, 2 and 4. Scenes on MPI_COMM_SELF are the
// one-rank run that the shared run must equal.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "rock_scene.h"

namespace muckpile::test {
namespace {

const std::string kUnbreakable = " density 2600 cohesion 1e12 friction_angle 45 tension 1e12";
enum Joint {
  joints = 1,
  broken = 2,
  elastic = 4,
  fracture = 5,
  friction = 6,
  damping = 7,
  stable_step = 8
};

std::string uniform(double size, int seed = 3) {
  const std::string s = std::to_string(size);
  return "density 2600 size uniform " + s + " block_min " + s + " block_max " + s +
         " spheres_per_block 2 seed " + std::to_string(seed);
}

TEST(FixMuckpileJoint, TwoBlocksPulledApartBreakAtTheTensileStrength) {
  RockScene scene(MPI_COMM_WORLD, "-3 3 -2 2 -2 2");
  scene.cut("-1 1 -0.5 0.5 -0.5 0.5", uniform(1.0) + " sweeps 100");
  scene.command(
      "fix joint all muckpile/joint youngs_modulus 50e9 poisson_ratio 0 density 2600 cohesion 1e12 "
      "friction_angle 45 tension 2e6");
  const auto start = scene.blocks();
  ASSERT_EQ(start.size(), 2u);
  const Vec3 across = start.at(2).centre - start.at(1).centre;
  const double h = across.norm();  // after 100 sweeps the facet lies at right angles to it
  const Vec3 apart = across / h;
  scene.set_motion([&](int tag, const Vec3&) {
    return Motion{(tag == 2 ? 0.25 : -0.25) * apart, Vec3::Zero()};
  });
  // The pair swings to 0.5 m/s / sqrt(2 x 50e9 / 2600) = 80 um; the strength is reached at 2e6 /
  // 50e9 of h = 1 m, 40 um, where it parts at 0.43 m/s: a step of 0.4 us is 0.4 % of the strength.
  const auto stress = [&] {
    const auto now = scene.blocks();
    return 50e9 / h * ((now.at(2).centre - now.at(1).centre).dot(apart) - h);
  };
  double before = 0.0;
  for (int step = 0; step < 1000 && scene.output("joint", broken) == 0.0; ++step) {
    before = stress();
    scene.run(1, 4e-7);
  }
  ASSERT_EQ(scene.output("joint", broken), 1.0);
  EXPECT_LT(before, 2e6 * 1.002);  // a facet tilted by 2 degrees feels 0.1 % less
  EXPECT_GT(stress(), 2e6 * 0.998);
  EXPECT_LT(stress() - before, 0.01 * 2e6);
  // 1/2 sigma^2 / E over the 1 m3 between the centres
  EXPECT_NEAR(scene.output("joint", fracture) / (0.5 * 2e6 * 2e6 / 50e9), 1.0, 0.015);
  const auto parted = scene.blocks();
  scene.run(500, 4e-7);
  for (const auto& [tag, block] : scene.blocks()) {
    EXPECT_EQ((block.velocity - parted.at(tag).velocity).norm(), 0.0);  // free flight
  }
}

/// Second minimum of the kinetic energy after a column is loaded along its axis at once [s].
double vibration_period(double nu, double length, double size, double guess) {
  const std::string end = std::to_string(length);
  RockScene scene(MPI_COMM_WORLD, "-2 " + std::to_string(length + 2.0) + " -2 3 -2 3");
  scene.command("region base block -0.1 0.001 -1 2 -1 2 units box");
  scene.cut("0 " + end + " 0 1 0 1", uniform(size) + " support mirror base");
  scene.command("fix joint all muckpile/joint youngs_modulus 50e9 poisson_ratio " +
                std::to_string(nu) + kUnbreakable);
  scene.command("fix pull all gravity 10 vector 1 0 0");
  const double dt = guess / 1600.0;  // 6 us, a seventh of the stable step
  scene.run(static_cast<int>(0.9 * guess / dt), dt);
  std::vector<double> energy;
  for (int k = 0; k < 41; ++k) {
    energy.push_back(scene.kinetic_energy());
    scene.run(8, dt);
  }
  const auto low =
      static_cast<std::size_t>(std::min_element(energy.begin(), energy.end()) - energy.begin());
  EXPECT_GT(low, 0u);
  EXPECT_LT(low, energy.size() - 1);
  if (low == 0 || low + 1 == energy.size()) return 0.0;
  const double left = energy[low - 1] - energy[low], right = energy[low + 1] - energy[low];
  const double between = 0.5 * (left - right) / (left + right);  // vertex of the parabola
  return dt * (std::floor(0.9 * guess / dt) + 8.0 * (static_cast<double>(low) + between));
}

TEST(FixMuckpileJoint, ColumnWithFreeSidesVibratesAtItsAnalyticFrequency) {
  constexpr double length = 10.0;                                 // [m]
  const double period = 4.0 * length / std::sqrt(50e9 / 2600.0);  // bar, one end held, one free
  for (const double nu : {0.0, 0.25, 0.4}) {
    const double measured = vibration_period(nu, length, 0.5, period);
    // Asked for is 1 %. Measured +0.08, +0.11, +0.11 %: blocks of 0.5 m on 10 m, two across;
    // lateral
    // inertia would be 0.01 %.
    EXPECT_NEAR(measured / period, 1.0, 0.003) << nu;
  }
}

TEST(FixMuckpileJoint, ZeroStrengthJointEqualsNoJoint) {
  std::array<std::map<int, BlockNow>, 2> result;
  for (const bool joined : {false, true}) {
    RockScene scene(MPI_COMM_WORLD, "-6 6 -6 6 -6 6");
    scene.command("pair_style muckpile/block youngs_modulus 1e8");
    scene.command("pair_coeff * *");
    scene.cut("-1.5 1.5 -1 1 -1 1", uniform(0.7));
    if (joined) {
      scene.command(
          "fix joint all muckpile/joint youngs_modulus 50e9 poisson_ratio 0.25 density 2600 "
          "cohesion 0 "
          "friction_angle 45 tension 0 step_check 0");  // they never close again
    }
    scene.set_motion([](int tag, const Vec3& at) {
      return Motion{2.0 * at, Vec3(0.1 * (tag % 3), 0, 0.1)};
    });
    scene.run(1000, 1e-4);
    result[joined ? 1 : 0] = scene.blocks();
    if (joined) {
      EXPECT_EQ(scene.output("joint", broken), scene.output("joint", joints));
    }
  }
  ASSERT_EQ(result[0].size(), result[1].size());
  for (const auto& [tag, block] : result[0]) {
    // The first step stretches rounding-level facets: a break gives up what 1e-16 m holds, no more.
    EXPECT_LT((block.centre - result[1].at(tag).centre).norm(), 1e-12) << tag;
    EXPECT_LT((block.spin - result[1].at(tag).spin).norm(), 1e-10) << tag;
  }
}

Motion spinning(const Vec3& at, double rate) {
  const Vec3 spin(0.2 * rate, -0.3 * rate, rate);
  return {Vec3(3, -2, 1) + spin.cross(at) +
              0.02 * rate * Vec3(std::sin(3 * at.y()), std::cos(2 * at.z()), 0),
          spin};
}

/// Faces lean against the lines between centres: the terms of leaning_faces.h act.
const std::string kLeaning = " cut joint_sets joint_set 75 90 joint_set 85 0 joint_set 10 270";

/// A bonded lump of some 40 blocks about the origin.
void make_lump(RockScene& scene, const std::string& strength, const std::string& cut = "") {
  scene.cut("-1 1 -1 1 -0.6 0.6", uniform(0.5) + cut);
  scene.command(
      "fix joint all muckpile/joint youngs_modulus 50e9 poisson_ratio 0.25 density 2600 "
      "contact_check no " +
      strength);
  scene.command("fix ledger all muckpile/ledger");
}

TEST(FixMuckpileJoint, FreeSpinningBodyKeepsMomentumAndEnergy) {
  RockScene scene(MPI_COMM_WORLD, "-4 4 -4 4 -4 4");
  make_lump(scene, "cohesion 1e12 friction_angle 45 tension 1e12");
  scene.set_motion([](int, const Vec3& at) { return spinning(at, 20.0); });
  const auto sums = [&] {
    std::pair<Vec3, Vec3> sum{Vec3::Zero(), Vec3::Zero()};
    for (const auto& [tag, b] : scene.blocks()) {
      sum.first += b.mass * b.velocity;
      sum.second += b.mass * b.centre.cross(b.velocity) + b.angular_momentum;
    }
    return sum;
  };
  const auto start = sums();
  const double energy = scene.kinetic_energy();
  scene.run(0, 1e-5);
  double worst = 0.0, most_elastic = 0.0;
  for (int part = 0; part < 20; ++part) {
    scene.run(200, 1e-5);  // 40 ms: 0.8 rad
    const double now = scene.kinetic_energy() + scene.output("joint", elastic);
    most_elastic = std::max(most_elastic, scene.output("joint", elastic));
    worst = std::max(worst, std::abs(now / energy - 1.0));
  }
  const auto end = sums();
  EXPECT_GT(most_elastic, 1e-4 * energy);
  // Second order, (omega dt)^2/8 of the vibrating part (1.6e-4 of the energy): measured 3e-7.
  EXPECT_LT(worst, 2e-6);
  EXPECT_LT(scene.output("ledger", 0), 2e-6);
  EXPECT_NEAR(scene.output("ledger", 1) / scene.kinetic_energy(), 1.0, 1e-12);
  // Rounding of 4000 steps: measured 4e-15 and 2e-15.
  EXPECT_LT((end.first - start.first).norm(), 1e-13 * start.first.norm());
  EXPECT_LT((end.second - start.second).norm(), 1e-13 * start.second.norm());
}

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
double broken_on_ranks(const std::string& strength, const std::string& cut = "",
                       double books = 1e-3) {
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
  // dilatations is not booked: measured 3e-4 and 6e-4 on 2 and 4 ranks.
  EXPECT_NEAR(shared.output("joint", fracture), taken, books * taken);
  return count;
}

TEST(FixMuckpileJoint, RanksShareABreakingBodyWithoutChangingIt) { broken_on_ranks(kStrength); }

TEST(FixMuckpileJoint, RanksShareABreakingBodyOfLeaningBlocks) {
  broken_on_ranks(kStrength, kLeaning, 3e-3);  // 1.3e-3; 1.5e-3 with the law of Voronoi blocks
}

TEST(FixMuckpileJoint, RanksShareASofteningBodyWithoutChangingIt) {
  EXPECT_NE(broken_on_ranks(kSoftening), broken_alone(kStrength));
}

TEST(FixMuckpileJoint, RanksShareABodyWhoseStrengthGrowsWithItsRate) {
  EXPECT_NE(broken_on_ranks(kRate), broken_alone(kStrength));
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

TEST(FixMuckpileJoint, SofteningBooksTheEnergyThatItTakes) {
  RockScene scene(MPI_COMM_WORLD, "-4 4 -4 4 -4 4");
  make_lump(scene, "cohesion 1e12 friction_angle 45 tension 1e12");
  scene.set_motion([](int, const Vec3& at) { return spinning(at, 20.0); });
  scene.run(500, 1e-5);
  const double before = scene.output("joint", elastic), step = scene.output("joint", stable_step);
  scene.command("fix_modify joint soften 0.25");
  scene.run(0, 1e-5);
  EXPECT_NEAR(scene.output("joint", elastic) / (0.25 * before), 1.0, 1e-10);
  EXPECT_NEAR(scene.output("joint", fracture) / (0.75 * before), 1.0, 1e-10);
  EXPECT_NEAR(scene.output("joint", stable_step) / (2.0 * step), 1.0, 1e-12);  // 1/sqrt(stiffness)
  scene.run(500, 1e-5);
  EXPECT_LT(scene.output("ledger", 0), 2e-6);  // as of the spinning body
}

}  // namespace
}  // namespace muckpile::test
