// SPDX-License-Identifier: GPL-2.0-or-later
// Gas in broken joints: equilibrium, steady flow, conservation of mass, and the force it makes.
// Scope: facet networks without the engine; blocks stay where the test puts them.
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <numeric>

#include "args/input_error.h"
#include "explosive/gas_vent.h"
#include "gas_scene.h"

namespace muckpile {
namespace {

using test::BondScene;
using test::chamber_of;
using test::closed;
using test::density_at;
using test::energy_of;
using test::GasScene;
using test::kGamma;
using test::kOpening;
using test::open_wide;
using test::press;
using test::seal;
using test::weak;

TEST(JointGas, VolumeIsHalfTheApertureOfEveryBrokenJoint) {
  GasScene row(test::cuboids(3, 1, 1), closed());
  row.fill(1, 0.1);
  row.gas.measure(JointRooms(row.scene.network()), row.fed);
  const double joint = 0.5 * (1e-4 + kOpening);  // of 1 m2
  EXPECT_NEAR(row.gas.cells()[0].volume, joint, 1e-12);
  EXPECT_NEAR(row.gas.cells()[1].volume, 2.0 * joint, 1e-12);
}

TEST(JointGas, TwoBlocksComeToThePressureOfAllTheEnergy) {
  GasScene pair(test::cuboids(2, 1, 1), closed());
  seal(pair.gas);
  pair.fill(0, 0.01);
  for (int n = 0; n < 4000; ++n) pair.step(5e-6);
  pair.gas.measure(JointRooms(pair.scene.network()), pair.fed);
  const double energy = energy_of(0.01, 100e6, density_at(100e6));
  const double expected = (kGamma - 1.0) * energy / (1e-4 + kOpening);  // of 1 m2
  EXPECT_NEAR(pair.pressure(0) / expected, 1.0, 1e-9);
  EXPECT_NEAR(pair.pressure(1) / expected, 1.0, 1e-9);
  EXPECT_NEAR(pair.mass(0) + pair.mass(1), 0.01, 4000 * 2e-18);  // a rounding a step
  EXPECT_NEAR(pair.energy() / energy, 1.0, 1e-14);
}

TEST(JointGas, SteadyFlowThroughARowIsTheSumOfItsJoints) {
  // Ends kept at 100 and 20 MPa, n joints. What flows keeps its temperature (throttling), so
  // across a joint G^2/2 (1 + f L/(2w)) = gamma/(gamma + 1) p rho [1 - (p'/p)^((gamma + 1)/gamma)]
  // with p rho = p^2/(R T). The joints are so narrow that none of them chokes.
  constexpr int kBlocks = 7;
  GasScene row(test::cuboids(kBlocks, 1, 1), closed());
  seal(row.gas);
  const double aperture = 1e-4 + kOpening, width = 2.0 / std::sqrt(M_PI);
  const double per_mass = 100e6 / density_at(100e6);  // R T [J/kg]
  const auto hold = [&](int b, double pressure) {
    const double volume = 0.5 * aperture, mass = pressure / per_mass * volume;
    row.gas.cells()[static_cast<std::size_t>(b)].content = {
        mass, pressure * volume / (kGamma - 1.0), 0.0, volume, 0.5e-4};
  };
  double through = 0.0;
  for (int n = 0; n < 200000; ++n) {  // 1 s
    hold(0, 100e6);
    hold(kBlocks - 1, 20e6);
    const double before = row.mass(kBlocks - 1);
    row.step(5e-6);
    through = (row.mass(kBlocks - 1) - before) / (5e-6 * aperture * width);
  }
  const double f = CrackFlow({.gamma = kGamma, .roughness = 1e-4}).friction_factor(aperture);
  const double resistance = 1.0 + f * width / (2.0 * aperture);
  // Pressures along the row for a flux, from the upstream end.
  const auto end_of = [&](double flux) {
    double p = 100e6;
    for (int k = 1; k < kBlocks; ++k) {
      const double fall = 0.5 * flux * flux * resistance * (kGamma + 1.0) / kGamma * per_mass;
      p *= std::pow(std::max(0.0, 1.0 - fall / (p * p)), kGamma / (kGamma + 1.0));
    }
    return p;
  };
  double low = 0.0, high = 1e6;
  for (int k = 0; k < 200; ++k)
    (end_of(0.5 * (low + high)) > 20e6 ? low : high) = 0.5 * (low + high);
  EXPECT_NEAR(through / low, 1.0, 1e-6);
  for (std::size_t b = 1; b + 1 < kBlocks; ++b)
    EXPECT_NEAR(row.gas.cells()[b].content.energy * (kGamma - 1.0) / (row.mass(b) * per_mass), 1.0,
                1e-6);
}

TEST(JointGas, FrontIsSlowerThanSound) {  // all but the little that an upwind scheme spreads
  constexpr int kBlocks = 12;
  GasScene row(test::cuboids(kBlocks, 1, 1), closed());
  seal(row.gas);
  // Of gas that has come into an empty joint: gamma times as hot as the chamber's.
  const double sound = kGamma * std::sqrt(200e6 / density_at(200e6));
  double time = 0.0;
  for (; time < 5e-3; time += 5e-6) {
    row.fill(0, density_at(200e6) * 0.5 * (1e-4 + kOpening), 200e6);
    row.step(5e-6);
  }
  double beyond = 0.0, all = 0.0;
  for (int b = 1; b < kBlocks; ++b) {
    all += row.mass(b);
    if (b > sound * time) beyond += row.mass(b);
  }
  ASSERT_GT(all, 0.0);
  EXPECT_LT(sound * time, kBlocks - 2);
  EXPECT_LT(beyond / all, 1e-2);  // measured 0.002
}

TEST(JointGas, ChamberFeedsAtTheChokedFluxIntoEmptyJoints) {
  JointGas::Parameters p = closed();
  p.flow.roughness = 0.0;
  GasScene pair(test::cuboids(2, 1, 1), p, 1);
  for (int& code : pair.gas.touches()) code = 2;
  pair.chambers[0] = chamber_of(100e6, 1e6);
  const double flux = choked_flux(100e6, density_at(100e6), kGamma);
  const double area = (1e-4 + kOpening) * 2.0 / std::sqrt(M_PI);  // both halves of the crack
  for (int n = 0; n < 20; ++n) pair.step(1e-6);
  EXPECT_NEAR(pair.taken[0].mass / (flux * area * 20e-6), 1.0, 1e-12);
  EXPECT_NEAR((pair.mass(0) + pair.mass(1)) / pair.taken[0].mass, 1.0, 1e-14);
  for (int n = 0; n < 4000; ++n) pair.step(1e-5);  // to the pressure of the chamber
  pair.gas.measure(JointRooms(pair.scene.network()), pair.fed);
  EXPECT_NEAR(pair.gas.pressure(pair.gas.cells()[0]) / 100e6, 1.0, 1e-9);
}

// As in a hole that fires into rock which is wide open already: in one step the joints could take
// more energy than a dense gas has, whose enthalpy is more than gamma times its energy.
TEST(JointGas, DenseGasKeepsItsEnergyAboveNothing) {
  constexpr double kMass = 1e-3, kEnergy = 1.5e6, kEnthalpy = 3e6;  // [kg], [J/kg]
  GasScene cube(test::voronoi_blocks(4.0, 3), closed(), 1);
  for (int& code : cube.gas.touches()) code = 2;
  cube.chambers[0] = {{1.5e9, 1000.0}, kMass, kEnthalpy, 0.0, 0.0, kEnergy / kEnthalpy};
  cube.step(1e-2);
  EXPECT_LT(cube.taken[0].energy / (kMass * kEnergy), 1.0);
  EXPECT_GT(cube.taken[0].energy / (kMass * kEnergy), 0.99);
  EXPECT_NEAR(cube.taken[0].energy / (cube.taken[0].mass * kEnthalpy), 1.0, 1e-12);
}

TEST(JointGas, SmallChamberIsNotEmptiedByManyJoints) {
  // A chamber with a fiftieth of the joints' volume, and steps so long that only the limit holds.
  GasScene cube(test::voronoi_blocks(4.0, 3), closed(), 1);
  for (int& code : cube.gas.touches()) code = 2;
  cube.gas.measure(JointRooms(cube.scene.network()), cube.fed);
  double volume = 0.0;
  for (const GasCell& cell : cube.gas.cells()) volume += cell.volume;
  const double room = volume / 50.0, start = density_at(150e6) * room;
  const double together = 150e6 * room / (room + volume);  // pressure when all has spread
  GasFlow left{start, energy_of(start, 150e6, density_at(150e6))};
  double least = 1e300;
  for (int n = 0; n < 2000; ++n) {
    const double pressure = (kGamma - 1.0) * left.energy / room;
    cube.chambers[0] = {{pressure, left.mass / room}, left.mass, kGamma * left.energy / left.mass};
    const GasFlow before = cube.taken[0];
    cube.step(1e-2);
    left.mass -= cube.taken[0].mass - before.mass;
    left.energy -= cube.taken[0].energy - before.energy;
    least = std::min(least, left.energy);
  }
  EXPECT_GT((kGamma - 1.0) * least / room / together, 1.0 - 1e-9);  // falls to it from above
  EXPECT_NEAR((kGamma - 1.0) * left.energy / room / together, 1.0, 1e-3);
  for (const GasCell& cell : cube.gas.cells()) {
    if (cell.volume > 0.0) {
      EXPECT_NEAR(cube.gas.pressure(cell) / together, 1.0, 1e-2);
    }
  }
  EXPECT_NEAR((cube.gas.contained().mass + cube.vented + left.mass) / start, 1.0, 1e-12);
}

/// What rock with cracks of 0.05 to 1 mm takes in 10 ms from a chamber along one of its sides [kg].
double taken_in_10_ms(double dt) {
  JointGas::Parameters p = closed();
  p.joint.residual_aperture = 1e-5;
  const Mat3 mostly_along_x = Vec3(1.0, 0.05, 0.05).asDiagonal();
  GasScene cube(test::voronoi_blocks(6.0, 3), p, 1, mostly_along_x);
  seal(cube.gas);
  for (std::size_t b = 0; b < cube.gas.cells().size(); ++b) {
    if (cube.scene.block(b).centre.y() < 1.0) cube.gas.touches()[b] = 2;
  }
  cube.chambers[0] = chamber_of(50e6, 1e3);
  const auto steps = std::lround(10e-3 / dt);
  for (int n = 0; n < steps; ++n) cube.step(dt);
  return cube.taken[0].mass;
}

TEST(JointGas, LongStepFillsRockAsFastAsAShortOne) {
  const double error = taken_in_10_ms(1e-4) / taken_in_10_ms(5e-6) - 1.0;
  std::cout << "taken with steps of 100 us over that with 5 us: " << 100.0 * error << " %\n";
  EXPECT_NEAR(error, 0.0, 2e-3);  // with equal shares for all ways out -0.5 %
}

TEST(JointGas, SurfaceLetsGasOutDownToTheAtmosphere) {
  JointGas::Parameters p = closed();
  p.ambient = 1e5;
  GasScene pair(test::cuboids(2, 1, 1), p);
  pair.fill(0, 0.01);
  pair.fill(1, 0.02);
  for (int n = 0; n < 20000; ++n) pair.step(1e-5);
  pair.gas.measure(JointRooms(pair.scene.network()), pair.fed);
  EXPECT_NEAR(pair.gas.pressure(pair.gas.cells()[0]) / 1e5, 1.0, 1e-6);
  EXPECT_NEAR(pair.mass(0) + pair.mass(1) + pair.vented, 0.03, 1e-15);
}

/// `open_gas` as in JointGas::Parameters.
void expect_mass_kept(double open_gas) {
  JointGas::Parameters p = closed();
  p.open_gas = open_gas;
  GasScene cube(test::voronoi_blocks(4.0, 3), p, 1);
  for (std::size_t b = 0; b < 6; ++b) cube.gas.touches()[b] = 2;
  cube.chambers[0] = chamber_of(150e6, 50.0);
  double filled = 0.0;
  for (std::size_t b = 10; b < 20; ++b) {
    cube.fill(b, 0.01 * static_cast<double>(b));
    filled += 0.01 * static_cast<double>(b);
  }
  for (int n = 0; n < 3000; ++n) {
    cube.gas.measure(JointRooms(cube.scene.network()), cube.fed);
    if (n % 500 == 499) {  // joints open beyond what they bear
      cube.scene.block(static_cast<std::size_t>(n / 500)).centre += Vec3(0.9, 0.6, 0.3);
      cube.scene.compute();
    }
    press(cube.gas, cube.scene.network());
    const JointGas::Flows flows = cube.gas.flow(cube.chambers, 5e-6);
    cube.vented += flows.vented.mass + open_wide(cube.gas, cube.scene.network());
    cube.taken[0] += flows.from_hole[0];
  }
  double least = 1.0;
  for (const GasCell& cell : cube.gas.cells()) least = std::min(least, cell.content.mass);
  EXPECT_GE(least, 0.0);
  EXPECT_GT(cube.vented, 0.1 * filled);
  EXPECT_GT(cube.taken[0].mass, 0.0);
  EXPECT_NEAR((cube.gas.contained().mass + cube.vented) / (filled + cube.taken[0].mass), 1.0,
              1e-12);
}

TEST(JointGas, MassIsKeptThroughFlowOutflowAndRetiringJoints) {
  expect_mass_kept(1.0);
  expect_mass_kept(5.0);
}

TEST(JointGas, PressurePushesBothBlocksApartWithItsTrueResultant) {
  JointGas::Parameters p = closed();
  p.ambient = 1e5;
  GasScene pair(test::cuboids(2, 1, 1), p);
  pair.fill(0, 0.01);
  pair.fill(1, 0.02);
  pair.gas.measure(JointRooms(pair.scene.network()), pair.fed);
  press(pair.gas, pair.scene.network());
  pair.scene.network().step(0.0);
  const auto gauge = [&](std::size_t b) { return pair.pressure(b) - 1e5; };
  const double expected = 0.5 * (gauge(0) + gauge(1));  // on 1 m2
  ASSERT_GT(expected, 1e6);
  EXPECT_NEAR(pair.scene.network().force()[0].x() / -expected, 1.0, 1e-12);
  EXPECT_NEAR(pair.scene.network().force()[1].x() / expected, 1.0, 1e-12);
  EXPECT_NEAR(pair.scene.network().torque()[0].norm() / expected, 0.0, 1e-12);
  EXPECT_EQ(pair.scene.network().gas_force()[1], pair.scene.network().force()[1]);
}

TEST(JointGas, ClosedJointCarriesTheRestOfTheLoad) {
  // Terzaghi: what squeezes the blocks is gas and contact; the contact alone bears friction.
  GasScene pair(test::cuboids(2, 1, 1), closed());
  pair.scene.deform(kOpening * 0.99 * Mat3::Identity());  // closed by 1e-5 m
  pair.scene.compute();
  const double contact = pair.scene.network().force()[1].x();
  pair.fill(0, 0.002);
  pair.fill(1, 0.002);
  pair.gas.measure(JointRooms(pair.scene.network()), pair.fed);
  EXPECT_NEAR(pair.gas.cells()[0].volume, 0.5e-4, 1e-14);
  press(pair.gas, pair.scene.network());
  pair.scene.network().step(0.0);
  const double pressure = (kGamma - 1.0) * pair.energy() / 1e-4;  // of both, in 1e-4 m3
  EXPECT_NEAR((pair.scene.network().force()[1].x() - contact) / pressure, 1.0, 1e-9);
}

TEST(JointGas, IntactJointsHoldNoGas) {
  BondScene pair(test::cuboids(2, 1, 1), test::rock(0.25));
  pair.compute();
  JointGas gas(closed());
  gas.set_rooms(JointRooms(pair.network()));
  gas.cells()[0].content = {1.0, 1e6, 0.0, 0.0};
  gas.measure(JointRooms(pair.network()), {});
  EXPECT_EQ(gas.cells()[0].volume, 0.0);
  press(gas, pair.network());
  pair.network().step(0.0);
  EXPECT_EQ(pair.network().force()[0].norm(), 0.0);
}

TEST(JointGas, OpeningJointCoolsItsGasAlongTheIsentrope) {
  GasScene pair(test::cuboids(2, 1, 1), closed());
  seal(pair.gas);
  pair.fill(0, 0.01);
  pair.fill(1, 0.01);
  pair.open(2.0 * kOpening);
  const double before = pair.energy(), volume = pair.gas.cells()[0].volume;
  double work = 0.0;
  for (int n = 1; n <= 200; ++n) {                // by a mm in small steps
    work += pair.pressure(0) * 0.005 * kOpening;  // on 1 m2, which it presses for the step
    pair.open((2.0 + 0.005 * n) * kOpening);
  }
  const double expected = before * std::pow(volume / pair.gas.cells()[0].volume, kGamma - 1.0);
  EXPECT_NEAR(pair.energy() / expected, 1.0, 1e-3);  // by the steps, in all
  EXPECT_NEAR(pair.gas.spent().work / (before - pair.energy()), 1.0, 1e-12);
  EXPECT_NEAR(work / pair.gas.spent().work, 1.0, 1e-3);
  EXPECT_NEAR(pair.gas.spent().swept_volume / kOpening, 1.0, 1e-9);
}

TEST(JointGas, PressureIsPaidForWhileFacesStillTouch) {
  // What the faces give way by is no room, but the blocks move: U falls by p dV of that, p as it
  // was held meanwhile.
  GasScene pair(test::cuboids(2, 1, 1), closed());
  seal(pair.gas);
  pair.fill(0, 0.002);
  pair.fill(1, 0.002);
  pair.open(0.90 * kOpening);  // closed by 0.1 mm
  const double before = pair.energy(), volume = pair.gas.cells()[0].volume;
  double work = 0.0;
  for (int n = 1; n <= 200; ++n) {
    work += pair.pressure(0) * 0.0004 * kOpening;  // on 1 m2
    pair.open((0.90 + 0.0004 * n) * kOpening);
  }
  EXPECT_NEAR(pair.gas.cells()[0].volume / volume, 1.0, 1e-12);
  EXPECT_GT(work / before, 0.1);
  EXPECT_NEAR((before - pair.energy()) / work, 1.0, 1e-9);
  EXPECT_NEAR(pair.gas.spent().swept_volume / (0.08 * kOpening), 1.0, 1e-9);
}

TEST(JointGas, PaysForThePressureThatPressed) {  // whatever has flowed since
  GasScene pair(test::cuboids(2, 1, 1), closed());
  seal(pair.gas);
  pair.fill(0, 0.01);
  pair.fill(1, 0.01);
  pair.open(2.0 * kOpening);
  const double pressed = pair.pressure(0);
  for (const std::size_t b : {0u, 1u}) {  // twice as much flows in before the blocks move
    pair.gas.cells()[b].content.mass *= 2.0;
    pair.gas.cells()[b].content.energy *= 2.0;
  }
  pair.open(2.0001 * kOpening);
  EXPECT_NEAR(pair.gas.spent().work / (pressed * 1e-4 * kOpening), 1.0, 1e-4);
}

TEST(JointGas, NeverPaysMoreThanItHas) {  // of a step that takes twice its energy
  JointGas::Parameters p = closed();
  p.ambient = 1e5;
  GasScene pair(test::cuboids(2, 1, 1), p);
  seal(pair.gas);
  pair.fill(0, 0.01);
  pair.fill(1, 0.01);
  pair.open(2.0 * kOpening);
  const double before = pair.energy(), pressed = pair.pressure(0);
  const double by = 2.0 * before / pressed;  // on 1 m2 [m]
  ASSERT_LT(by, 0.5);
  pair.open(2.0 * kOpening + by);
  const GasSpent& spent = pair.gas.spent();
  EXPECT_NEAR(spent.work / (before - pair.energy()), 1.0, 1e-12);
  EXPECT_NEAR(pair.energy() / (0.5 * before * std::exp(-3.0)), 1.0, 1e-9);
  EXPECT_NEAR(spent.air_work / (spent.work * 1e5 / pressed), 1.0, 1e-9);
}

TEST(JointGas, FacesThatGiveWayAsUnseenAreNotPaidFor) {  // as behind a restart file
  GasScene pair(test::cuboids(2, 1, 1), closed());
  seal(pair.gas);
  pair.fill(0, 0.002);
  pair.open(0.90 * kOpening);
  pair.gas.look_at_all();
  pair.open(0.95 * kOpening);
  EXPECT_EQ(pair.gas.spent().work, 0.0);
  pair.open(0.96 * kOpening);
  EXPECT_GT(pair.gas.spent().work, 0.0);
}

TEST(JointGas, EmptyRoomFillsToGammaTimesTheTemperature) {
  // The textbook's evacuated vessel: U = m h of what came in from a great chamber, T = gamma T0.
  GasScene pair(test::cuboids(2, 1, 1), closed(), 1);
  for (int& code : pair.gas.touches()) code = 2;
  pair.chambers[0] = chamber_of(100e6, 1e6);
  for (int n = 0; n < 4000; ++n) pair.step(1e-5);
  const GasContent& gas = pair.gas.cells()[0].content;
  const double chamber = energy_of(1.0, 100e6, density_at(100e6));  // [J/kg]
  EXPECT_NEAR(gas.energy / gas.mass / (kGamma * chamber), 1.0, 1e-9);
}

TEST(JointGas, NewRoomCostsNoWork) {  // Joule: a joint that breaks beside gas keeps its energy
  GasScene row(test::cuboids(3, 1, 1), closed());
  seal(row.gas);
  row.fill(1, 0.01);
  row.gas.measure(JointRooms(row.scene.network()), row.fed);
  const double before = row.energy();
  row.gas.measure(JointRooms(row.scene.network()), row.fed);
  EXPECT_EQ(row.energy(), before);
  EXPECT_EQ(row.gas.spent().work, 0.0);
}

TEST(JointGas, EnergyIsKeptThroughFlowWorkHeatAndOutflow) {
  JointGas::Parameters p = closed();
  p.ambient = 1e5;
  p.heat.effusivity = 2500.0;
  GasScene cube(test::voronoi_blocks(4.0, 3), p, 1);
  for (std::size_t b = 0; b < 6; ++b) cube.gas.touches()[b] = 2;
  cube.chambers[0] = chamber_of(150e6, 50.0);
  for (std::size_t b = 10; b < 20; ++b) cube.fill(b, 0.01 * static_cast<double>(b));
  const double filled = cube.energy();
  double taken = 0.0, vented = 0.0;
  for (int n = 0; n < 2000; ++n) {
    cube.open((2.0 + 1e-3 * n) * kOpening);
    press(cube.gas, cube.scene.network());
    cube.chambers[0].ways = cube.gas.chamber_ways()[0];
    const JointGas::Flows flows = cube.gas.flow(cube.chambers, 5e-6);
    cube.gas.cool(5e-6);
    taken += flows.from_hole[0].energy;
    vented += flows.vented.energy;
  }
  const GasSpent& spent = cube.gas.spent();
  EXPECT_GT(taken, 0.1 * filled);
  EXPECT_GT(vented, 0.01 * filled);
  EXPECT_GT(spent.heat, 0.01 * filled);
  EXPECT_GT(spent.work, 0.01 * filled);
  const double error = (cube.energy() + vented + spent.heat + spent.work) / (filled + taken) - 1.0;
  std::cout << "energy of the gas: off by " << error << '\n';
  EXPECT_NEAR(error, 0.0, 1e-12);
}

TEST(JointGas, WallsTakeHeatOnlyWhereGasFlows) {
  JointGas::Parameters p = closed();
  p.heat.effusivity = 2500.0;
  GasScene pair(test::cuboids(2, 1, 1), p);
  seal(pair.gas);
  pair.fill(0, 0.02);
  pair.fill(1, 0.02);
  for (int n = 0; n < 100; ++n) pair.step(5e-6);
  EXPECT_EQ(pair.gas.spent().heat, 0.0);  // at rest: the film is that of the flow
  pair.fill(1, 0.002);
  for (int n = 0; n < 100; ++n) pair.step(5e-6);
  EXPECT_GT(pair.gas.spent().heat, 0.0);
  EXPECT_NEAR(pair.gas.cells()[0].content.heat + pair.gas.cells()[1].content.heat,
              pair.gas.spent().heat, 1e-9 * pair.gas.spent().heat);
}

/// Two blocks, gas of which has flowed from the first to the second and warmed the joint's faces.
struct WarmPair : GasScene {
  static JointGas::Parameters parameters() {
    JointGas::Parameters p = closed();
    p.heat.effusivity = 2500.0;
    return p;
  }
  WarmPair() : GasScene(test::cuboids(2, 1, 1), parameters()) {
    seal(gas);
    flow(0.02, 0.002, 1.0);
  }
  GasContent& content(std::size_t b) { return gas.cells()[b].content; }
  /// For 0.5 ms; `hot`: of the energy that gas of this density has.
  void flow(double first, double second, double hot) {
    fill(0, first);
    fill(1, second);
    for (const std::size_t b : {0u, 1u}) content(b).energy *= hot;
    for (int n = 0; n < 100; ++n) step(5e-6);
  }
};

TEST(JointGas, WallsHoldWhatTheyHaveTakenWhenMoreHaveBroken) {
  WarmPair pair;
  for (const std::size_t b : {0u, 1u}) {  // as if half of the faces had been there so far
    pair.content(b).wall *= 0.5;
    pair.content(b).heat *= 0.5;
  }
  pair.flow(0.02, 0.002, 1.0);
  for (const std::size_t b : {0u, 1u}) {
    const GasContent& gas = pair.content(b);
    EXPECT_GT(gas.heat, 0.0);
    EXPECT_NEAR(RockLayers::half_space(2500.0).heat(gas.rock) * gas.wall / gas.heat, 1.0, 1e-9);
  }
}

TEST(JointGas, WarmWallsGiveHeatToColdGasThatFlows) {
  WarmPair pair;
  const double heat = pair.gas.spent().heat;
  pair.flow(0.02, 0.002, 0.05);
  EXPECT_LT(pair.gas.spent().heat, 0.99 * heat);
  EXPECT_GT(pair.gas.spent().heat, 0.0);
}

TEST(JointGas, WarmthGoesOnIntoTheRockBehindGasAtRest) {
  WarmPair pair;
  const double heat = pair.gas.spent().heat, face = pair.content(0).rock[0];
  pair.flow(0.02, 0.02, 1.0);
  EXPECT_EQ(pair.gas.spent().heat, heat);
  EXPECT_LT(pair.content(0).rock[0], 0.9 * face);
}

TEST(JointGas, RefusesWhatIsNoAperture) {
  JointGas::Parameters p = closed();
  p.joint.residual_aperture = 0.0;
  EXPECT_THROW(JointGas{p}, InputError);
  p = closed();
  p.ambient = -1.0;
  EXPECT_THROW(JointGas{p}, InputError);
  p = closed();
  p.gas_constant = 0.0;
  EXPECT_THROW(JointGas{p}, InputError);
  p = closed();
  p.open_gas = 0.9;
  EXPECT_THROW(JointGas{p}, InputError);
}

}  // namespace
}  // namespace muckpile
