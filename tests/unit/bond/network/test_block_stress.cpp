// SPDX-License-Identifier: GPL-2.0-or-later
// Mean stress of blocks, and how far points are from them.
// Scope: unit cubes moved by hand; of a cube with one loaded facet, forces and arms are known.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "bond/network/block_stress.h"
#include "bond_scene.h"

namespace muckpile::test {
namespace {

constexpr double kRounding = 1e-9;  // of jumps of 1e-5 m at coordinates of 1 m

Mat3 stress_of(BondScene& scene, int block) {
  return block_stresses(scene.network(), std::array{block}).front();
}

TEST(BlockStress, IsTheContinuumsInAHomogeneousStrain) {
  BondScene scene(cuboids(7, 7, 7, Vec3(1.0, 0.8, 1.3)), rock(0.25));
  Mat3 e;
  e << 1.0, 0.3, -0.2, 0.3, -0.5, 0.4, -0.2, 0.4, 0.7;
  e *= 1e-6;
  scene.deform(e);
  scene.compute();
  const JointMaterial& material = scene.network().material();
  const Mat3 exact =
      material.lame_lambda() * e.trace() * Mat3::Identity() + 2.0 * material.shear_modulus() * e;
  const int middle = 3 + 7 * (3 + 7 * 3);  // far from the free faces: it reads two blocks on
  EXPECT_LT((stress_of(scene, middle) - exact).norm() / exact.norm(), 1e-4);
}

/// Two cubes along x; the facet's arm from the first is half a metre.
struct Pair {
  explicit Pair(const JointParameters& parameters) : scene(cuboids(2, 1, 1), parameters) {}
  void part(double x, double y) {
    scene.block(1).centre = scene.start(1) + Vec3(x, y, 0.0);
    scene.compute(1e-9);
  }
  /// The two blocks carry the same facet: F (x) r of one is that of the other.
  void expect_force_times_arm() {
    const Vec3 force = scene.network().force()[0];
    ASSERT_GT(force.norm(), 0.0);
    for (const int block : {0, 1}) {
      const Mat3 stress = stress_of(scene, block);
      EXPECT_NEAR(stress(0, 0), 0.5 * force.x(), 1e-4 * force.norm());
      EXPECT_NEAR(stress(0, 1), 0.25 * force.y(), 1e-4 * force.norm());
      EXPECT_NEAR(stress(1, 0), stress(0, 1), 1e-9 * force.norm());
      EXPECT_NEAR(stress(2, 2), 0.0, 1e-9 * force.norm());
    }
  }
  BondScene scene;
};

JointParameters weak_rock() {
  JointParameters p = rock(0.25);
  p.tension = 1e6;
  p.cohesion = 2e6;
  return p;
}

TEST(BlockStress, OfAnIntactJointIsItsForceTimesItsArm) {
  Pair pair(rock(0.25));
  pair.part(2e-5, 1e-5);
  pair.expect_force_times_arm();
}

TEST(BlockStress, OfABrokenJointIsThatOfItsContact) {
  Pair pair(weak_rock());
  pair.part(1e-4, 0.0);
  ASSERT_EQ(pair.scene.network().broken_count(), 1.0);
  EXPECT_NEAR(stress_of(pair.scene, 0).norm(), 0.0, 1e-9);  // open
  pair.part(-1e-5, 0.0);
  pair.part(-1e-5, 2e-6);
  EXPECT_LT(stress_of(pair.scene, 0)(0, 0), -1e5);
  pair.expect_force_times_arm();
}

TEST(BlockStress, OfASofteningJointIsWhatItStillHolds) {
  JointParameters p = weak_rock();
  p.fracture_energy_tension = p.fracture_energy_shear = 200.0;
  Pair pair(p);
  pair.part(1e-4, 0.0);
  ASSERT_EQ(pair.scene.network().broken_count(), 1.0);
  EXPECT_GT(stress_of(pair.scene, 0)(0, 0), 1e4);
  pair.expect_force_times_arm();
}

TEST(BlockStress, HasThePressureOfGasInTheJoint) {
  Pair pair(weak_rock());
  pair.scene.network().keep_gas_in_joints();
  pair.part(1e-4, 0.0);
  pair.scene.network().set_gas_pressure(std::array{3e5, 1e5, 0.0});
  pair.part(1e-4, 0.0);
  // The mean of the two pressures, midway between the sides.
  EXPECT_NEAR(stress_of(pair.scene, 0)(0, 0), -2e5 * (0.5 + 0.5e-4), 1e-3);
  pair.expect_force_times_arm();
}

TEST(BlockStress, HasThePressureOnTheWallOfACrushedZone) {
  BondScene scene(cuboids(1, 1, 1), rock(0.25));
  for (BoundaryFace& face : scene.network().faces()) {
    if (face.normal.x() > 0.5) {
      face.hole = 0;
      face.pressure = 4e6;
    }
  }
  scene.compute();
  Mat3 expected = Mat3::Zero();
  expected(0, 0) = -0.5 * 4e6;  // pressure x area x half an edge / volume
  EXPECT_LT((stress_of(scene, 0) - expected).norm(), kRounding * 4e6);
}

TEST(BlockStress, OfSeveralBlocksIsInTheOrderAskedFor) {
  BondScene scene(cuboids(3, 1, 1), rock(0.25));
  scene.block(2).centre.x() += 1e-5;
  scene.compute();
  const auto both = block_stresses(scene.network(), std::array{2, 0});
  EXPECT_EQ(both[0], stress_of(scene, 2));
  EXPECT_EQ(both[1], stress_of(scene, 0));
}

TEST(BlockDistance, IsNegativeWithinAndThatOfTheFarthestFaceOutside) {
  BondScene scene(cuboids(2, 1, 1), rock(0.25));
  const auto at = [&](const Vec3& point) { return distances_from_blocks(scene.network(), point); };
  EXPECT_NEAR(at({0.3, 0.5, 0.5})[0], -0.3, 1e-6);
  EXPECT_NEAR(at({0.3, 0.5, 0.5})[1], 0.7, 1e-6);
  EXPECT_NEAR(at({2.4, 0.5, 0.9})[1], 0.4, 1e-6);
  EXPECT_EQ(at({0, 0, 0}).size(), 2U);  // the ground is none of them
  scene.move_rigidly(Vec3(0.0, 0.0, M_PI / 2.0), Vec3(0.0, 0.0, 5.0));
  const Vec3 moved = Vec3(-0.5, 0.3, 5.5);  // of (0.3, 0.5, 0.5), if it turns about the origin
  EXPECT_LT(at(moved)[0], 0.0);
}

}  // namespace
}  // namespace muckpile::test
