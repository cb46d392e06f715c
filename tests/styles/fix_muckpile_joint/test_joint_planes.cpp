// SPDX-License-Identifier: GPL-2.0-or-later
// Natural joints from a script: the cut follows them, and rock slides on them by their own
// friction. Scope: a cube of rock cut by one plane that dips 30 degrees to the east (+x).
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "rock_scene.h"

namespace muckpile::test {
namespace {

constexpr double kGravity = 9.81, kDip = M_PI / 6.0, kTimeStep = 2e-5;  // [m/s2], [rad], [s]

/// Tied to the ground at z = -1 m; everything but the plane is too strong to break.
void stand_on_plane(RockScene& scene, const std::string& joint) {
  scene.command("region base block -2 2 -2 2 -1.1 -0.999 units box");
  scene.cut("-1 1 -1 1 -1 1",
            "density 2600 size uniform 0.5 block_min 0.5 block_max 0.5 spheres_per_block 2 seed 3 "
            "support fixed base joint_plane 0 0 0 30 90 1");
  scene.command(
      "fix joint all muckpile/joint youngs_modulus 5e9 poisson_ratio 0.25 density 2600 cohesion "
      "1e12 friction_angle 45 tension 1e12 damping 0.05 contact_check no joint_class 1 law " +
      joint);
  scene.command("fix weight all gravity 9.81 vector 0 0 -1");
}

std::string coulomb(const std::string& friction) {
  return "coulomb friction_angle " + friction + " residual_friction_angle " + friction;
}

/// Mean velocity down the dip of what lies above the plane [m/s].
double sliding(const RockScene& scene) {
  const Vec3 down(std::cos(kDip), 0.0, -std::sin(kDip)), up(std::sin(kDip), 0.0, std::cos(kDip));
  double momentum = 0.0, mass = 0.0;
  for (const auto& [tag, block] : scene.blocks()) {
    if (up.dot(block.centre) < 0.0) continue;
    momentum += block.mass * down.dot(block.velocity);
    mass += block.mass;
  }
  EXPECT_NEAR(mass / (2600.0 * 4.0), 1.0, 1e-6);  // half of 8 m3: no block crosses the plane
  return momentum / mass;
}

/// With a friction of 20 degrees.
void expect_to_slide(const std::string& joint) {
  RockScene scene(MPI_COMM_WORLD, "-2 2 -2 2 -2 2");
  stand_on_plane(scene, joint);
  scene.run(1000, kTimeStep);
  const double before = sliding(scene);
  scene.run(4000, kTimeStep);  // 9 mm: a tenth of the facets' radius starts their fading
  const double gained = sliding(scene) - before;
  const double expected = kGravity * (std::sin(kDip) - std::tan(M_PI / 9.0) * std::cos(kDip));
  EXPECT_NEAR(gained / (4000 * kTimeStep) / expected, 1.0,
              0.02);  // it swings by up to 3 mm/s, of 145 gained
}

TEST(JointPlanes, RockSlidesAsOnAnInclinedPlane) { expect_to_slide(coulomb("20")); }

TEST(JointPlanes, RockSlidesOnWornJointsOfBartonAndBandis) {
  expect_to_slide(
      "barton_bandis initial_stiffness 1e10 closure_limit 1e-4 roughness 10 wall_strength 1e8 "
      "residual_friction_angle 20 largest_angle 20");
}

TEST(JointPlanes, RockStaysWhereFrictionHolds) {
  RockScene scene(MPI_COMM_WORLD, "-2 2 -2 2 -2 2");
  stand_on_plane(scene, coulomb("40"));
  scene.run(1500, kTimeStep);
  // It swings, as the weight comes at once: g x 2 m / c_S = 14 mm/s without damping. Sliding freely
  // it would have gained 147 mm/s by now, with the friction of 20 degrees 54.
  EXPECT_LT(std::abs(sliding(scene)), 0.01);
}

}  // namespace
}  // namespace muckpile::test
