// SPDX-License-Identifier: GPL-2.0-or-later
// fix muckpile/joint in the engine: strength, vibration, momentum, energy, softening.
// Scope: up to some hundred blocks; run with mpirun -np 1 and 2.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "lump.h"

namespace muckpile::test {
namespace {

const std::string kUnbreakable = " density 2600 cohesion 1e12 friction_angle 45 tension 1e12";

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
