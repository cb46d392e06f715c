// SPDX-License-Identifier: GPL-2.0-or-later
// Walls of broken joints that crush: a face that leans, and faces of different strength side by
// side.
// Scope: two or three blocks of 1 m moved by hand; faces are of 1 m2, so forces [N] are tractions
// [Pa].
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "bond_scene.h"
#include "loose_rock.h"

namespace muckpile::test {
namespace {

void move(BondScene& scene, std::size_t block, const Vec3& path, int steps) {
  const double dt = path.norm() / steps;  // at 1 m/s
  scene.block(block).velocity = path / (steps * dt);
  for (int k = 0; k < steps; ++k) {
    scene.block(block).centre += path / steps;
    scene.compute(dt);
  }
  scene.block(block).velocity.setZero();
}

/// The pressure across it is limited, whatever the axes, and with it the friction along it.
TEST(CrushingFaces, AFaceThatLeansIsLimitedAcrossIt) {
  const Mat3 turn = Eigen::AngleAxisd(std::numbers::pi / 6.0, Vec3(0.2, 0.3, 1.0).normalized())
                        .toRotationMatrix();
  std::vector<Block> blocks = cuboids(2, 1, 1);
  for (Block& block : blocks) {
    for (Vec3& v : block.shape.vertices) v = turn * v;
    block.mass = mass_properties(block.shape);
  }
  BondScene scene(blocks, loose_rock(0.25));
  scene.compute();
  const Vec3 normal = turn * Vec3::UnitX(), along = turn * Vec3::UnitY();
  const auto pressure = [&] { return -scene.network().force()[0].dot(normal); };
  const auto shear = [&] { return scene.network().force()[0].dot(along); };
  move(scene, 1, 1e-6 * normal, 1);
  move(scene, 1, -0.5e-3 * normal, 10);
  EXPECT_NEAR(pressure() / 30e6, 1.0, 1e-7);  // the way there leaves rounding in the turned frame
  move(scene, 1, -2.5e-3 * normal, 50);
  EXPECT_NEAR(pressure() / kWalls, 1.0, 1e-9);
  EXPECT_NEAR(shear() / kWalls, 0.0, 1e-6);
  move(scene, 1, 4e-3 * along, 100);
  EXPECT_NEAR(shear() / (kWalls * std::tan(0.5)), 1.0, 1e-6);
  EXPECT_NEAR(pressure() / kWalls, 1.0, 1e-6);
}

/// A block between one of its own rock, whose walls never crush, and one of rock whose walls do.
TEST(CrushingFaces, EachFaceHasTheStrengthOfItsOwnWalls) {
  const JointParameters hard = loose_rock(0.25, std::numeric_limits<double>::infinity());
  BondScene scene(cuboids(3, 1, 1), hard, [](const Vec3&) { return Support::free; }, {},
                  Leaning::little, {{loose_rock(0.25)}, {0, 0, 1}});
  scene.compute();
  move(scene, 0, {-1e-6, 0, 0}, 1);
  move(scene, 2, {1e-6, 0, 0}, 1);
  const double before = scene.network().losses().crushing;
  move(scene, 0, {2.5e-3, 0, 0}, 50);
  EXPECT_EQ(scene.network().losses().crushing, before);
  move(scene, 2, {-2.5e-3, 0, 0}, 50);
  EXPECT_NEAR(-scene.network().force()[0].x() / 150e6, 1.0, 1e-6);  // 2.5 mm at 60 GPa/m
  EXPECT_NEAR(scene.network().force()[2].x() / kWalls, 1.0, 1e-9);
  EXPECT_NEAR(scene.network().losses().crushing / (kWalls * (2.5e-3 - kWalls / 60e9)), 1.0, 0.02);
}

}  // namespace
}  // namespace muckpile::test
