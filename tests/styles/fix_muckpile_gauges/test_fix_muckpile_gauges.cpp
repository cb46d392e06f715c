// SPDX-License-Identifier: GPL-2.0-or-later
// fix muckpile/gauges: a plane wave along a bar against d'Alembert, rock that flies and turns, the
// same on any number of ranks, a block that leaves the box.
// Scope: rock that does not break; words that are refused are in tests/errors.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <sstream>
#include <string>

#include "gauge_rows.h"
#include "rock_scene.h"
#include "scratch_folder.h"

namespace muckpile::test {
namespace {

constexpr double kYoung = 50e9, kPoisson = 0.25, kDensity = 2600.0;  // [Pa], [-], [kg/m3]
const std::string kJoint =
    "fix joint all muckpile/joint youngs_modulus 50e9 poisson_ratio 0.25 density 2600 cohesion "
    "1e12 friction_angle 50 tension 1e12 contact_check no";

// A bar of cubes between mirrors, struck by a velocity of half a metre per second at its peak.
constexpr int kCubes = 60;
constexpr double kEdge = 0.1, kMiddle = 1.5, kHalfWidth = 1.0, kSpeed = 0.5;  // [m], [m/s]
const double kModulus = kYoung * (1 - kPoisson) / ((1 + kPoisson) * (1 - 2 * kPoisson));  // [Pa]
const double kWave = std::sqrt(kModulus / kDensity);  // of P waves [m/s]

double shape(double x) {
  const double off = (x - kMiddle) / kHalfWidth;
  return std::abs(off) < 1.0 ? std::pow(std::cos(0.5 * M_PI * off), 2) : 0.0;
}

void strike_bar(RockScene& scene, const std::filesystem::path& folder, const std::string& gauges) {
  scene.command("region sides block -1 7 -0.0499 0.0499 -0.0499 0.0499 side out units box");
  std::ostringstream words;
  words << "density 2600 size uniform 0.24 block_min 0.24 block_max 0.24 spheres_per_block 1 seed "
           "2 support mirror sides";
  for (int k = 1; k < kCubes; ++k) words << " joint_plane " << k * kEdge << " 0 0 90 90 0";
  scene.cut("0 6 -0.05 0.05 -0.05 0.05", words.str());
  scene.command(kJoint);
  scene.set_motion([](int, const Vec3& at) {
    return Motion{Vec3(kSpeed * shape(at.x()), 0, 0), Vec3::Zero()};
  });
  scene.command("fix gauges all muckpile/gauges directory " + folder.string() + " " + gauges);
}

/// The right-going half of the pulse has half the speed, and at the gauge the stress rho c v. Of
/// speed, time and stress 0.6 % are off at most, which for the time is less than a step, of the
/// lateral stress 1.6 %.
TEST(FixMuckpileGauges, PlaneWaveArrivesAsDAlembertSays) {
  constexpr double kAllowed = 0.01, kLateral = 0.02, kStep = 3e-6;
  const ScratchFolder folder("gauges_wave");
  RockScene scene(MPI_COMM_WORLD, "-0.3 6.3 -0.3 0.3 -0.3 0.3");
  strike_bar(scene, folder / "", "every 1 gauge 3.25 0 0 gauge 4.25 0.03 -0.02");
  ASSERT_EQ(scene.blocks().size(), static_cast<std::size_t>(kCubes));
  scene.run(270, kStep);  // the pulse is past the second gauge, reflections are not there yet
  const auto rows = gauge_rows(folder / "gauges.csv");
  for (const auto& [gauge, place] : {std::pair(1, 3.25), std::pair(2, 4.25)}) {
    const auto history = rows_of(rows, gauge);
    ASSERT_EQ(history.size(), 271U);
    const GaugeRow peak = *std::ranges::max_element(
        history, {}, [](const GaugeRow& row) { return row.velocity.x(); });
    const GaugeRow most = *std::ranges::min_element(
        history, {}, [](const GaugeRow& row) { return row.stress(0, 0); });
    const double stress = -0.5 * kDensity * kWave * kSpeed;
    std::cout << "gauge " << gauge << ": speed " << peak.velocity.x() / (0.5 * kSpeed) << ", time "
              << peak.time / ((place - kMiddle) / kWave) << ", stress "
              << most.stress(0, 0) / stress << ", lateral "
              << most.stress(1, 1) / most.stress(0, 0) * (1 - kPoisson) / kPoisson << '\n';
    EXPECT_NEAR(peak.velocity.x() / (0.5 * kSpeed), 1.0, kAllowed);
    EXPECT_NEAR(peak.time / ((place - kMiddle) / kWave), 1.0, kAllowed);
    EXPECT_NEAR(most.stress(0, 0) / stress, 1.0, kAllowed);
    EXPECT_NEAR(most.time / ((place - kMiddle) / kWave), 1.0, kAllowed);
    EXPECT_NEAR(most.stress(1, 1) / most.stress(0, 0), kPoisson / (1 - kPoisson), kLateral);
    EXPECT_NEAR(most.stress(2, 2) / most.stress(0, 0), kPoisson / (1 - kPoisson), kLateral);
    EXPECT_NEAR(most.pressure, -most.stress.trace() / 3.0, 1e-6 * std::abs(stress));
    // The integral of the right-going pulse.
    EXPECT_NEAR(history.back().moved.x() / (0.5 * kSpeed * kHalfWidth / kWave), 1.0, kAllowed);
  }
}

/// A lump that flies to the right and spins about z, over the border between ranks.
constexpr double kFlight = 60.0, kSpin = 3.0;  // [m/s], [rad/s]

void throw_lump(RockScene& scene, const std::filesystem::path& folder, const std::string& gauges) {
  scene.cut("-1 1 -0.5 0.5 -0.5 0.5",
            "density 2600 size uniform 0.5 block_min 0.5 block_max 0.5 spheres_per_block 1 seed 3");
  scene.command(kJoint);
  scene.set_motion([](int, const Vec3& at) {
    const Vec3 spin(0, 0, kSpin);
    return Motion{Vec3(kFlight, 0, 0) + spin.cross(at), spin};
  });
  scene.command("fix gauges all muckpile/gauges directory " + folder.string() + " " + gauges);
}

/// Where a point of the lump is, were it rigid, less where it began.
Vec3 flown(const Vec3& start, double time) {
  const Mat3 turned = Eigen::AngleAxisd(kSpin * time, Vec3::UnitZ()).toRotationMatrix();
  return Vec3(kFlight * time, 0, 0) + turned * start - start;
}

TEST(FixMuckpileGauges, RideWithRockThatFliesAndTurnsOnAllRanks) {
  const ScratchFolder folder("gauges_flight");
  RockScene scene(MPI_COMM_WORLD, "-3 9 -3 3 -3 3");
  throw_lump(scene, folder / "", "interval 0.005 gauge 0.9 0.4 0.1 line -0.9 -0.3 0 0.1 0.2 0.3 3");
  scene.run(4000, 2e-5);  // 4.8 m
  const auto rows = gauge_rows(folder / "gauges.csv");
  ASSERT_EQ(rows.size(), 4U * 17U);
  EXPECT_NEAR((rows[2].start - Vec3(-0.4, -0.05, 0.15)).norm(), 0.0, 1e-12);  // middle of the line
  for (const GaugeRow& row : rows) {
    const Vec3 moved = flown(row.start, row.time);
    const Vec3 velocity =
        Vec3(kFlight, 0, 0) +
        Vec3(0, 0, kSpin).cross(Vec3(row.start + moved - Vec3(kFlight * row.time, 0, 0)));
    EXPECT_NEAR((row.moved - moved).norm(), 0.0, 1e-4);        // strain by its own spin: 1e-6
    EXPECT_NEAR((row.velocity - velocity).norm(), 0.0, 0.01);  // it swings as it starts
  }
  EXPECT_NEAR(rows.back().time, 0.08, 1e-9);
}

/// Each rank alone against all of them together.
TEST(FixMuckpileGauges, AreTheSameOnAnyNumberOfRanks) {
  const ScratchFolder folder("gauges_ranks");
  const std::string words = "every 20 line -0.9 -0.3 0 0.9 0.2 0.3 5";
  {
    RockScene alone(MPI_COMM_SELF, "-3 9 -3 3 -3 3");
    throw_lump(alone, folder.own("alone"), words);
    alone.run(2000, 2e-5);
  }
  RockScene together(MPI_COMM_WORLD, "-3 9 -3 3 -3 3");
  throw_lump(together, folder / "together", words);
  together.run(2000, 2e-5);
  const auto all = gauge_rows(folder / "together/gauges.csv");
  EXPECT_EQ(all.size(), 5U * 101U);
  EXPECT_LT(difference(all, gauge_rows(folder.own("alone") / "gauges.csv")), 1e-4);
}

TEST(FixMuckpileGauges, ABlockThatLeavesTheBoxTakesItsGaugeWithIt) {
  const ScratchFolder folder("gauges_lost");
  RockScene scene(MPI_COMM_WORLD, "-3 3 -3 3 -3 3");
  scene.command("thermo_modify lost ignore");
  throw_lump(scene, folder / "", "every 100 gauge 0.9 0.1 0.1 gauge -0.9 0.1 0.1");
  scene.run(2400, 2e-5);  // 2.9 m: of the two ends only one has left
  const auto rows = gauge_rows(folder / "gauges.csv");
  EXPECT_LT(rows_of(rows, 1).size(), 25U);
  EXPECT_EQ(rows_of(rows, 2).size(), 25U);
}

}  // namespace
}  // namespace muckpile::test
