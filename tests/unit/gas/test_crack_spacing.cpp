// SPDX-License-Identifier: GPL-2.0-or-later
// Joints of the cut that stand for several cracks of the rock, which share their opening.
// Scope: facet networks without the engine; blocks stay where the test puts them.
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <string>

#include "args/input_error.h"
#include "bond/law/barton_bandis.h"
#include "gas_scene.h"

namespace muckpile {
namespace {

using test::BondScene;
using test::chamber_of;
using test::closed;
using test::GasScene;
using test::kGamma;
using test::kOpening;
using test::press;
using test::seal;
using test::weak;

JointGas::Parameters with_spacing(double spacing) {
  JointGas::Parameters p = closed();
  p.crack_spacing = spacing;
  return p;
}

/// A cube of 4 m in blocks of about 1 m, all on a chamber and on the surface, with heat into walls.
struct FedCube {
  GasScene cube;
  GasFlow vented;

  static JointGas::Parameters laws(double spacing) {
    JointGas::Parameters p = with_spacing(spacing);
    p.heat.effusivity = 2500.0;
    p.joint.closure_share = 0.45;
    p.joint.closure_stiffness = 2.5e10;
    p.joint.roughness = 10.0;
    p.ambient = 1e5;
    return p;
  }
  explicit FedCube(double spacing) : cube(test::voronoi_blocks(4.0, 3), laws(spacing), 1) {
    int k = 0;
    for (int& code : cube.gas.touches()) code = k++ % 3 == 0 ? 3 : k % 3;
    for (int n = 0; n < 400; ++n) step(5e-6);
  }
  void step(double dt) {
    cube.chambers[0] = chamber_of(150e6, 100.0);
    cube.gas.measure(JointRooms(cube.scene.network()), cube.fed);
    press(cube.gas, cube.scene.network());
    cube.chambers[0].ways = cube.gas.chamber_ways()[0];
    const JointGas::Flows flows = cube.gas.flow(cube.chambers, dt);
    cube.gas.cool(dt);
    vented += flows.vented;
    cube.taken[0] += flows.from_hole[0];
  }
};

TEST(CrackSpacing, LargerThanTheBlocksItIsBitEqualToNone) {
  const FedCube none(0.0), wide(100.0);
  EXPECT_GT(none.cube.gas.contained().mass, 0.0);
  EXPECT_GT(none.vented.mass, 0.0);
  EXPECT_EQ(none.cube.gas.contained().mass, wide.cube.gas.contained().mass);
  EXPECT_EQ(none.cube.gas.contained().energy, wide.cube.gas.contained().energy);
  EXPECT_EQ(none.cube.gas.spent().heat, wide.cube.gas.spent().heat);
  EXPECT_EQ(none.vented.energy, wide.vented.energy);
}

TEST(CrackSpacing, MassAndEnergyAreKept) {
  const FedCube none(0.0), fine(0.3);
  const GasFlow contained = fine.cube.gas.contained(), taken = fine.cube.taken[0];
  const double mass = (contained.mass + fine.vented.mass) / taken.mass - 1.0;
  const double energy =
      (contained.energy + fine.vented.energy + fine.cube.gas.spent().heat) / taken.energy - 1.0;
  const double heat = fine.cube.gas.spent().heat / taken.energy,
               of_one = none.cube.gas.spent().heat / none.cube.taken[0].energy;
  std::cout << "cracks of 0.3 m in blocks of 1 m: mass off by " << mass << ", energy by " << energy
            << "; taken " << taken.mass / none.cube.taken[0].mass
            << " times that of one per joint, " << heat << " of it lost as heat, " << of_one
            << " with one\n";
  EXPECT_EQ(fine.cube.gas.spent().work, 0.0);  // nothing moves
  EXPECT_NEAR(mass, 0.0, 1e-12);
  EXPECT_NEAR(energy, 0.0, 1e-12);
  EXPECT_GT(heat, of_one);  // more walls, narrower cracks
}

TEST(CrackSpacing, FourCracksHaveTheRoomAndTheWaysOfFour) {
  GasScene pair(test::cuboids(2, 1, 1), with_spacing(0.25));
  seal(pair.gas);
  pair.fill(0, 0.01);
  pair.open(2.0 * kOpening);
  const double each = 1e-4 + 0.25 * kOpening, width = 2.0 / std::sqrt(M_PI);
  EXPECT_NEAR(pair.gas.cells()[0].volume / (0.5 * 4.0 * each), 1.0, 1e-9);
  const double passage = CrackFlow(closed().flow).passage(each, width);
  EXPECT_NEAR(pair.gas.cells()[0].ways / (4.0 * each * width * passage), 1.0, 1e-9);
}

TEST(CrackSpacing, MeanSizeOfTheTwoBlocksCounts) {
  // 1 m and 2 m long cuboids of 1 m2 across: (1 + 2^(1/3))/2 = 1.13 m of rock between the centres.
  std::vector<Block> blocks = test::cuboids(2, 1, 1);
  blocks[1] = test::cuboids(2, 1, 1, Vec3(2.0, 1.0, 1.0))[0];
  blocks[1].mass = mass_properties(blocks[1].shape);
  JointGas gas(with_spacing(0.5));
  BondScene scene(blocks, weak());
  scene.network().keep_gas_in_joints();
  for (const double by : {kOpening, 2.0 * kOpening}) {
    scene.block(1).centre.x() = scene.start(1).x() + by;
    scene.compute();
  }
  gas.set_rooms(JointRooms(scene.network()));
  gas.cells()[0].content = {0.01, 5e3};
  gas.measure(JointRooms(scene.network()), {});
  const double many = 0.5 * (1.0 + std::cbrt(2.0)) / 0.5;
  EXPECT_NEAR(gas.cells()[0].volume / (0.5 * (many * 1e-4 + kOpening)), 1.0, 1e-9);
}

TEST(CrackSpacing, OpeningWorksOnceHoweverManyShareIt) {
  for (const double many : {1.0, 4.0, 10.0}) {
    GasScene pair(test::cuboids(2, 1, 1), with_spacing(1.0 / many));
    seal(pair.gas);
    pair.fill(0, 0.01);
    pair.fill(1, 0.01);
    pair.open(2.0 * kOpening);
    const double before = pair.energy();
    pair.open(4.0 * kOpening);
    const double room = many * 1e-4;
    EXPECT_NEAR(pair.gas.spent().swept_volume / (2.0 * kOpening), 1.0, 1e-9) << many;
    EXPECT_NEAR(pair.gas.spent().work / (before - pair.energy()), 1.0, 1e-12) << many;
    // In one step, at the pressure that it had before.
    const double paid = (kGamma - 1.0) * 2.0 * kOpening / (room + kOpening);
    const double kept = paid > 0.5 ? 0.5 * std::exp(1.0 - 2.0 * paid) : 1.0 - paid;
    EXPECT_NEAR(pair.energy() / before / kept, 1.0, 1e-9) << many;
  }
}

JointGas::Parameters voids(double spacing) {
  JointGas::Parameters p = with_spacing(spacing);
  p.heat.effusivity = 2500.0;
  p.open_gas = 10.0;
  return p;
}

/// Heat into the walls of a joint with a radius of 0.56 m that is `opening` wide [J].
double heat_at(double opening, double spacing) {
  GasScene pair(test::cuboids(2, 1, 1), voids(spacing));
  seal(pair.gas);
  pair.fill(0, 1.0);
  pair.fill(1, 0.1);
  pair.open(opening);
  for (int n = 0; n < 20; ++n) pair.step(5e-6);
  return pair.gas.spent().heat;
}

TEST(CrackSpacing, PartedByItsRadiusAJointIsOneCrack) {
  const double joint = heat_at(0.1, 0.25) / heat_at(0.1, 0.0);
  std::cout << "heat into four cracks of a joint over that into one: " << joint << '\n';
  EXPECT_GT(joint, 1.1);
  EXPECT_GT(heat_at(0.8, 0.0), 0.0);
  EXPECT_EQ(heat_at(0.8, 0.25), heat_at(0.8, 0.0));
}

TEST(CrackSpacing, MassAndEnergyAreKeptAsAJointBecomesAVoidAndCloses) {
  GasScene pair(test::cuboids(2, 1, 1), voids(0.25));
  seal(pair.gas);
  pair.fill(0, 1.0);
  pair.fill(1, 0.1);
  pair.open(0.5);
  const double mass = pair.mass(0) + pair.mass(1), energy = pair.energy() + pair.gas.spent().work;
  for (const double opening : {0.55, 0.58, 0.8, 0.58, 0.55, 0.3}) {
    const double swept = pair.gas.spent().swept_volume, was = pair.gas.cells()[0].volume;
    pair.open(opening);
    for (int n = 0; n < 10; ++n) pair.step(5e-6);
    const GasSpent& spent = pair.gas.spent();
    EXPECT_NEAR((pair.mass(0) + pair.mass(1)) / mass, 1.0, 1e-12) << opening;
    EXPECT_NEAR((pair.energy() + spent.work + spent.heat) / energy, 1.0, 1e-12) << opening;
    // Of 1 m2: three closed cracks of 0.1 mm come and go, and the gas sweeps what the faces do.
    const double room = 2.0 * (pair.gas.cells()[0].volume - was) - (spent.swept_volume - swept);
    EXPECT_LT(std::abs(room), 3.0001e-4) << opening;
  }
  EXPECT_GT(pair.gas.spent().heat, 0.0);
}

TEST(CrackSpacing, JointWithALawOfItsOwnIsOneCrack) {
  const BartonBandis law{.initial_stiffness = 1e10,
                         .closure_limit = 1e-4,
                         .roughness = 10.0,
                         .wall_strength = 1e8,
                         .residual_angle = 0.5,
                         .largest_angle = 1.2,
                         .initial_aperture = 2e-4};
  BondScene scene(test::cuboids(2, 1, 1), weak(), [](const Vec3&) { return Support::free; },
                  {{barton_bandis_class(law, 2e10)}, {{Vec3(1, 0, 0), Vec3::UnitX(), 1}}});
  scene.network().keep_gas_in_joints();
  for (const double by : {1e-9, 1e-4}) {
    scene.block(1).centre.x() = scene.start(1).x() + by;
    scene.compute(1e-6);
  }
  for (const double spacing : {0.0, 0.1}) {
    JointGas gas(with_spacing(spacing));
    gas.set_rooms(JointRooms(scene.network()));
    gas.cells()[0].content = {0.01, 5e3};
    gas.measure(JointRooms(scene.network()), {});
    EXPECT_NEAR(gas.cells()[0].volume / (0.5 * 3e-4), 1.0, 1e-5) << spacing;
  }
}

TEST(CrackSpacing, RefusesWhatNoRockHas) {
  for (const double spacing : {-1.0, 1e-3, std::nan("")}) {
    try {
      const JointGas gas(with_spacing(spacing));
      FAIL() << spacing;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find("crack_spacing must be 0 or >= 0.01 m"),
                std::string::npos)
          << error.what();
    }
  }
}

}  // namespace
}  // namespace muckpile
