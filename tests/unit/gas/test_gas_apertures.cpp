// SPDX-License-Identifier: GPL-2.0-or-later
// Gas in joints that stress narrows or a law of their own knows, and in the voids that joints
// become. Scope: facet networks without the engine; blocks stay where the test puts them.
#include <gtest/gtest.h>

#include <cmath>

#include "bond/law/barton_bandis.h"
#include "gas_scene.h"

namespace muckpile {
namespace {

using test::BondScene;
using test::closed;
using test::GasScene;
using test::kGamma;
using test::kOpening;
using test::press;
using test::seal;
using test::weak;

TEST(JointGas, StressNarrowsAClosedJointWithTheWorkOfTheBlocksAlone) {
  // Two cubes of 50 GPa: a millionth of a metre closer is 50 kPa on the joint.
  JointGas::Parameters p = closed();
  p.joint.closure_share = 0.45;
  p.joint.closure_stiffness = 2.5e10;
  p.joint.roughness = 10.0;
  GasScene pair(test::cuboids(2, 1, 1), p);
  seal(pair.gas);
  pair.fill(0, 0.01);
  pair.fill(1, 0.01);
  pair.open(kOpening);  // touching
  EXPECT_NEAR(pair.gas.cells()[0].volume / 0.5e-4, 1.0, 1e-9);
  const double filled = pair.energy();
  double energy = filled, was_closer = 0.0, room = 1e-4;  // [J], [m], [m3] of both blocks
  for (const double closer : {1e-6, 1e-5, 1e-4, 1e-3, 5e-6}) {
    pair.open(kOpening - closer);
    const double stress = 50e9 * closer, limit = 0.45e-4;
    const double aperture = 1e-4 - limit * stress / (2.5e10 * limit + stress);
    EXPECT_NEAR(pair.gas.cells()[0].volume / (0.5 * aperture), 1.0, 1e-6) << closer;
    const double paid = (kGamma - 1.0) * (was_closer - closer) / room;  // on 1 m2
    energy *= paid > 0.5 ? 0.5 * std::exp(1.0 - 2.0 * paid) : 1.0 - paid;
    EXPECT_NEAR(pair.energy() / energy, 1.0, 1e-9) << closer;
    was_closer = closer;
    room = aperture;
    EXPECT_NEAR(pair.pressure(0) / ((kGamma - 1.0) * energy / aperture), 1.0, 1e-6) << closer;
  }
  // All that the blocks have moved counts, whatever stress the joint had meanwhile.
  pair.open(2.0 * kOpening);
  EXPECT_NEAR(pair.gas.spent().swept_volume / kOpening, 1.0, 1e-9);
  EXPECT_NEAR(pair.gas.spent().work / (filled - pair.energy()), 1.0, 1e-12);
}

TEST(JointGas, BelowTheAtmosphereItsWorkIsOnTheAir) {
  JointGas::Parameters p = closed();
  p.ambient = 1e5;
  for (const double pressure : {1e6, 0.3e5}) {
    GasScene pair(test::cuboids(2, 1, 1), p);
    seal(pair.gas);
    const double mass = test::density_at(pressure) * 0.5 * (1e-4 + kOpening);
    for (const std::size_t block : {0, 1}) pair.fill(block, mass, pressure);
    pair.open(2.0 * kOpening);
    const double before = pair.energy();
    pair.open(2.1 * kOpening);
    const GasSpent& spent = pair.gas.spent();
    EXPECT_NEAR(spent.work / (before - pair.energy()), 1.0, 1e-12);
    EXPECT_NEAR(spent.swept_volume / (0.1 * kOpening), 1.0, 1e-9);
    const bool pushes = pair.gas.press()[0] > 0.0;
    EXPECT_EQ(pushes, pressure > p.ambient);
    EXPECT_NEAR(spent.air_work / (pushes ? 1e5 * spent.swept_volume : spent.work), 1.0, 1e-12);
  }
}

/// Two sealed cubes that part slowly to 3 m, 5.3 radii; what their gas had done on them beyond the
/// atmosphere as it was let go, and what it could still have done then [J].
struct SlowParting {
  double work = 0.0, could_do = 0.0, energy = 0.0, let_go = 0.0, at = 0.0;

  explicit SlowParting(double open_gas) {
    JointGas::Parameters p = closed();
    p.ambient = 1e5;
    p.open_gas = open_gas;
    GasScene pair(test::cuboids(2, 1, 1), p);
    seal(pair.gas);
    pair.fill(0, 0.5);
    pair.fill(1, 0.5);
    const double start = 0.5;
    pair.open(start);
    const double first = pair.energy(), volume = pair.gas.cells()[0].volume;
    for (at = start; at < 3.0; at += 1e-3) {
      pair.open(at);
      press(pair.gas, pair.scene.network());
      const double adiabat = first * std::pow(volume / pair.gas.cells()[0].volume, kGamma - 1.0);
      EXPECT_NEAR(pair.energy() / adiabat, 1.0, 1e-3) << at;  // by the steps, in all
      energy = pair.energy();
      work = pair.gas.spent().work - 1e5 * pair.gas.spent().swept_volume;
      const JointGas::Opened opened = pair.gas.open_wide();
      let_go = opened.vented.energy;
      could_do = opened.could_do;
      if (!opened.joints.empty()) break;
    }
    EXPECT_EQ(pair.energy(), 0.0);
    EXPECT_NEAR((first - pair.gas.spent().work) / let_go, 1.0, 1e-12);
  }
};

TEST(JointGas, VoidKeepsItsGasUntilItHasExpandedToTheAtmosphere) {
  const SlowParting at_once(1.0), at_two(2.0), kept(10.0);
  EXPECT_NEAR(at_once.at, 1.0 / std::sqrt(M_PI), 2e-3);  // the radius of 1 m2
  EXPECT_NEAR(at_two.at, 2.0 / std::sqrt(M_PI), 2e-3);
  EXPECT_GT(kept.at, at_two.at);
  EXPECT_LT(kept.at, 2.9);  // before it has parted by 10 radii: nothing left to do
  EXPECT_EQ(kept.could_do, 0.0);
  EXPECT_GT(at_once.could_do, 0.1 * at_once.energy);
  // What is not done is what could have been: the bound of what is lost without voids.
  EXPECT_NEAR((kept.work - at_once.work) / at_once.could_do, 1.0, 2e-3);
  EXPECT_NEAR((kept.work - at_two.work) / at_two.could_do, 1.0, 2e-3);
}

TEST(JointGas, BlockBetweenVoidsBearsThePressureGradientOfItsPlace) {
  JointGas::Parameters p = closed();
  p.ambient = 1e5;
  p.open_gas = 10.0;
  GasScene row(test::cuboids(3, 1, 1), p);
  seal(row.gas);
  for (const std::size_t b : {0u, 1u, 2u}) row.fill(b, 0.2 * static_cast<double>(4 - b));
  constexpr double kGap = 0.8;  // 1.4 radii: past the contact of the two faces
  row.open(kGap);
  ASSERT_EQ(row.scene.network().states()[0], FacetState::retired);
  press(row.gas, row.scene.network());
  EXPECT_TRUE(row.gas.open_wide().joints.empty());
  row.scene.network().step(0.0);
  const std::span<const Vec3> force = row.scene.network().gas_force();
  // A share of 1/(1 + gap) of the row is block; a bed without inertia of its gas bears all of the
  // pressure's fall: F = V/(1 - void share) (p0 - p2)/(2 pitch).
  const double pitch = 1.0 + kGap, place = 1.0 * pitch;
  const double expected = place * (row.pressure(0) - row.pressure(2)) / (2.0 * pitch);
  ASSERT_GT(expected, 1e4);
  EXPECT_NEAR(force[1].x() / expected, 1.0, 1e-12);
  EXPECT_LT((force[0] + force[1] + force[2]).norm(), 1e-12 * force[0].norm());
}

/// Two cubes of 1 m with a rough broken joint between them, whose faces were 0.2 mm apart at first.
struct RoughJoint {
  BartonBandis law{.initial_stiffness = 1e10,
                   .closure_limit = 1e-4,
                   .roughness = 10.0,
                   .wall_strength = 1e8,
                   .residual_angle = 0.5,
                   .largest_angle = 1.2,
                   .initial_aperture = 2e-4};
  BondScene scene{test::cuboids(2, 1, 1),
                  weak(),
                  [](const Vec3&) { return Support::free; },
                  {{barton_bandis_class(law, 2e10)}, {{Vec3(1, 0, 0), Vec3::UnitX(), 1}}}};
  JointGas gas{closed()};

  RoughJoint() {
    scene.network().keep_gas_in_joints();
    open(1e-9);  // no tension: breaks
    gas.set_rooms(JointRooms(scene.network()));
    gas.cells()[0].content = gas.cells()[1].content = {0.01, 5e3, 0.0, 0.0};
  }
  /// Volume of both blocks' gas [m3].
  double open(double by) {
    scene.block(1).centre.x() = scene.start(1).x() + by;
    scene.compute(1e-6);
    if (gas.cells().empty()) return 0.0;
    gas.measure(JointRooms(scene.network()), {});
    return gas.cells()[0].volume + gas.cells()[1].volume;
  }
};

TEST(JointGas, VolumeOfARoughJointGrowsByWhatItsPressureWorksOn) {
  RoughJoint joint;
  EXPECT_NEAR(joint.open(1e-4) / 3e-4, 1.0, 1e-5);  // times 1 m2
  EXPECT_NEAR((joint.open(2e-4) - joint.open(1e-4)) / 1e-4, 1.0, 1e-9);
  const double volume = joint.open(1e-4);
  press(joint.gas, joint.scene.network());
  joint.scene.compute();
  const double pressure = (kGamma - 1.0) * joint.gas.contained().energy / volume;
  EXPECT_NEAR(joint.scene.network().force()[1].x() / pressure, 1.0, 1e-9);
}

TEST(JointGas, RockBehindARoughJointGivesWayToo) {
  // What the joint closes by is room, what the rock in series does is none; both move the blocks.
  RoughJoint joint;
  const double closed = joint.open(-4e-4), swept = joint.gas.spent().swept_volume;
  const double room = joint.open(-3e-4) - closed;
  EXPECT_LT(room, 0.5e-4);  // of 1e-4 m by which the blocks part, on 1 m2
  EXPECT_NEAR((joint.gas.spent().swept_volume - swept) / 1e-4, 1.0, 1e-6);
}

TEST(JointGas, RoughJointBreaksWithTheApertureOfItsOwnLaw) {
  // A row whose second joint slips under pressure, closed, beside gas in the first: Joule's
  // expansion into E_0 less the closure, whatever `residual_aperture` joints of no law have.
  const RoughJoint pair;
  BondScene scene(test::cuboids(3, 1, 1), weak(), [](const Vec3&) { return Support::free; },
                  {{barton_bandis_class(pair.law, 2e10)},
                   {{Vec3(1, 0, 0), Vec3::UnitX(), 1}, {Vec3(2, 0, 0), Vec3::UnitX(), 1}}});
  scene.network().keep_gas_in_joints();
  const auto move = [&](double first, double second, double along) {
    for (const std::size_t b : {1u, 2u}) scene.block(b).centre = scene.start(b);
    scene.block(1).centre.x() += first;
    scene.block(2).centre += Vec3(first + second, along, 0.0);
    scene.compute(1e-6);
  };
  move(1e-9, 0.0, 0.0);
  JointGas gas(closed());
  gas.set_rooms(JointRooms(scene.network()));
  seal(gas);
  for (const std::size_t b : {0u, 1u}) gas.cells()[b].content = {0.01, 5e3};
  gas.measure(JointRooms(scene.network()), {});
  const double energy = gas.contained().energy, volume = gas.cells()[1].volume;
  constexpr double kCloser = 5e-5;
  move(1e-9, -kCloser, 2e-4);
  ASSERT_NE(scene.network().states()[1], FacetState::intact);
  gas.measure(JointRooms(scene.network()), {});
  const double closure = pair.law.close(kCloser, 50e9, 0.0).closure;
  ASSERT_GT(closure, 2e-5);
  EXPECT_NEAR((gas.cells()[1].volume - volume) / (0.5 * (2e-4 - closure)), 1.0, 1e-6);
  EXPECT_NEAR(gas.contained().energy / energy, 1.0, 1e-6);
  EXPECT_NEAR(gas.spent().swept_volume, 0.0, 1e-12);
  // What it parts from there on works.
  move(1e-9, 1e-4, 2e-4);
  gas.measure(JointRooms(scene.network()), {});
  EXPECT_NEAR(gas.spent().swept_volume / (0.5 * (1e-4 + closure)), 1.0, 1e-3);
}

TEST(JointGas, FlowOfARoughJointHasItsHydraulicAperture) {
  RoughJoint joint;
  joint.open(1e-4);  // e = 300^2/10^2.5 = 284.6 um
  const double e = joint.law.apertures(-1e-4).hydraulic, width = 2.0 / std::sqrt(M_PI);
  EXPECT_NEAR(e, 284.605e-6, 1e-9);
  const double way = e * width * CrackFlow(closed().flow).passage(e, width);
  // To the other block, and half of that to the free faces around.
  EXPECT_NEAR(joint.gas.cells()[0].ways / (1.5 * way), 1.0, 1e-4);
}

}  // namespace
}  // namespace muckpile
