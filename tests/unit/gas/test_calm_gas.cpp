// SPDX-License-Identifier: GPL-2.0-or-later
// Joints between calm blocks, looked at once in several steps: what flows is the same, and kept.
// Scope: facet networks without the engine; blocks move as the test moves them.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "args/input_error.h"
#include "gas_scene.h"

namespace muckpile {
namespace {

using test::chamber_of;
using test::closed;
using test::GasScene;
using test::kOpening;
using test::press;
using test::seal;

JointGas::Parameters looked_at_in_one_of(int steps) {
  JointGas::Parameters p = closed();
  p.calm_every = steps;
  return p;
}

/// Two blocks with pressures 0.2 % apart, which hardly flow within 50 ns.
GasScene calm_pair(int calm_every) {
  GasScene pair(test::cuboids(2, 1, 1), looked_at_in_one_of(calm_every));
  seal(pair.gas);
  pair.fill(0, 0.01);
  pair.fill(1, 0.00998);
  return pair;
}

/// The first cycle finds what they press, the second that it stays.
TEST(CalmGas, FlowsForEightStepsAtOnce) {
  GasScene pair = calm_pair(8), each = calm_pair(1);
  const auto step = [&](int steps) {
    for (int n = 0; n < steps; ++n) {
      pair.step(5e-8);
      each.step(5e-8);
    }
  };
  step(9);
  EXPECT_EQ(pair.mass(0), each.mass(0));
  const double before = pair.mass(0);
  step(7);
  EXPECT_EQ(pair.mass(0), before);
  step(1);
  const double flowed = before - each.mass(0);
  EXPECT_GT(flowed, 0.0);
  EXPECT_NEAR((before - pair.mass(0)) / flowed, 1.0, 0.05);  // the fall was that of the first step
  EXPECT_NEAR(pair.mass(0) + pair.mass(1), 0.01998, 1e-16);
}

TEST(CalmGas, WakesAsItsPressureChanges) {
  GasScene pair = calm_pair(8);
  for (int n = 0; n < 11; ++n) pair.step(5e-8);
  const double before = pair.mass(0);
  pair.fill(0, 0.02);
  pair.step(5e-8);  // this one finds it
  EXPECT_EQ(pair.mass(0), 0.02);
  pair.step(5e-8);
  EXPECT_LT(pair.mass(0), 0.02);
  EXPECT_GT(pair.mass(0), before);
}

/// The joint of a calm block opens to fifty times its width beside one that has lost its gas.
TEST(CalmGas, IsNotEmptiedByAJointThatOpens) {
  GasScene pair = calm_pair(8);
  for (int n = 0; n < 11; ++n) pair.step(5e-8);
  pair.fill(0, 1e-6);
  pair.step(5e-8);
  pair.scene.deform(50.0 * kOpening * Mat3::Identity());
  pair.scene.compute();
  pair.step(1e-3);
  EXPECT_GT(pair.mass(1), 0.0);
  EXPECT_NEAR(pair.mass(0) + pair.mass(1), 1e-6 + 0.00998, 1e-5);
}

/// A hole that fires behind measure() has ways into all blocks beside it, though one is calm: none
/// of its small gas is taken twice.
TEST(CalmGas, EmptiesNoHoleThatFires) {
  GasScene pair(test::cuboids(2, 1, 1), looked_at_in_one_of(8), 1);
  for (int& code : pair.gas.touches()) code = 2;
  pair.fed[0] = 0;
  pair.fill(0, 0.01);
  pair.fill(1, 0.01);
  for (int n = 0; n < 11; ++n) pair.step(5e-8);
  pair.fill(0, 0.0101);
  pair.step(5e-8);
  pair.chambers[0] = chamber_of(150e6, 1e-7);
  pair.step(5e-8);
  EXPECT_GT(pair.taken[0].mass, 0.0);
  EXPECT_LT(pair.taken[0].mass, 1e-7);
  EXPECT_NEAR(pair.mass(0) + pair.mass(1), 0.0201 + pair.taken[0].mass, 1e-15);
}

struct Kept {
  double mass_error = 0.0, energy_error = 0.0;  ///< over what there was [-]
  std::vector<double> pressures;                ///< per block [Pa]
};

/// Gas from a chamber and of ten blocks flows, works, cools and leaves rock that opens ever wider.
Kept cube_after_many_steps(int calm_every) {
  JointGas::Parameters p = looked_at_in_one_of(calm_every);
  p.ambient = 1e5;
  p.heat.effusivity = 2500.0;
  GasScene cube(test::voronoi_blocks(4.0, 3), p, 1);
  for (std::size_t b = 0; b < 6; ++b) cube.gas.touches()[b] = 2;
  cube.chambers[0] = chamber_of(150e6, 50.0);
  for (std::size_t b = 10; b < 20; ++b) cube.fill(b, 0.01 * static_cast<double>(b));
  const GasFlow filled = cube.gas.contained();
  GasFlow taken, vented;
  for (int n = 0; n < 2000; ++n) {
    cube.open((2.0 + 1e-3 * n) * kOpening);
    press(cube.gas, cube.scene.network());
    cube.chambers[0].ways = cube.gas.chamber_ways()[0];
    const JointGas::Flows flows = cube.gas.flow(cube.chambers, 5e-6);
    cube.gas.cool(5e-6);
    taken += flows.from_hole[0];
    vented += flows.vented;
  }
  const GasSpent& spent = cube.gas.spent();
  const GasFlow left = cube.gas.contained();
  Kept kept;
  kept.mass_error = (left.mass + vented.mass) / (filled.mass + taken.mass) - 1.0;
  kept.energy_error =
      (left.energy + vented.energy + spent.heat + spent.work) / (filled.energy + taken.energy) -
      1.0;
  for (const GasCell& cell : cube.gas.cells()) kept.pressures.push_back(cube.gas.pressure(cell));
  return kept;
}

TEST(CalmGas, KeepsMassAndEnergyAndPressesTheSame) {
  const Kept calm = cube_after_many_steps(8), each = cube_after_many_steps(1);
  EXPECT_NEAR(calm.mass_error, 0.0, 1e-12);
  EXPECT_NEAR(calm.energy_error, 0.0, 1e-12);
  EXPECT_NE(calm.pressures, each.pressures);  // some were left out
  for (std::size_t b = 0; b < each.pressures.size(); ++b)
    EXPECT_NEAR(calm.pressures[b], each.pressures[b], 0.02 * each.pressures[b]) << b;
}

TEST(CalmGas, RefusesNoStep) { EXPECT_THROW(JointGas(looked_at_in_one_of(0)), InputError); }

}  // namespace
}  // namespace muckpile
