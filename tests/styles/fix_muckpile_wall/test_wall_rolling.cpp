// SPDX-License-Identifier: GPL-2.0-or-later
// fix muckpile/wall in the engine: what rolling resistance leaves of the spin of a block that
// bounces, beside the law by itself and LIGGGHTS' own wall. Scope: a cube of 0.5 m with one sphere
// that falls at 5 m/s and spins, without friction.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>

#include "contact/contact_law.h"
#include "wall_scene.h"

namespace muckpile::test {
namespace {

constexpr double kSpeed = 5.0;        // [m/s]
constexpr double kRestitution = 0.5;  // [-]

const std::string kRolls = "muckpile/wall plane 0 0 0 0 0 1 friction 0 torsion yes";
const std::string kStockRolls =
    "wall/gran model hertz tangential history rolling_friction epsd2 primitive type 1 zplane 0 "
    "torsionTorque on";

struct Bounce {
  double spin;   ///< about y, after [rad/s]
  double share;  ///< of what the limit torque would take throughout: mu_r R times the momentum
};

Bounce bounce_on(const std::string& wall, double spin) {
  RockScene scene(MPI_COMM_WORLD, "-12 12 -4 4 -4 6", "* * 1", "multisphere/muckpile");
  add_contacts(scene, kRestitution, "friction 0 rolling_friction 1", "0");
  scene.command("fix m5 all property/global coefficientRollingFriction peratomtypepair 1 1");
  scene.command("fix floor all " + wall);
  scene.cut("0 0.5 -0.25 0.25 0.3 0.8", words(1));
  const double radius = scene.all_spheres().at(1).radius;
  scene.set_motion([spin](int, const Vec3&) {
    return Motion{Vec3(0, 0, -kSpeed), Vec3(0, spin, 0)};
  });
  scene.run(6000, kStep);
  const BlockNow block = scene.blocks().at(1);
  const double taken = block.inertia(1, 1) * (spin - block.spin.y());
  return {block.spin.y(), taken / (radius * block.mass * (kSpeed + block.velocity.z()))};
}

/// The contact law of the pair's page by itself: Hertz with its dashpot, never pulling; a rolling
/// spring of stiffness 8 G* a R^2 that keeps its torque as it stiffens and its angle as it softens,
/// of R N at most.
double spin_by_the_law(double spin) {
  constexpr double kEdge = 0.5, kRadius = 0.25 * 1.19, kModulus = 2.5e7, kNu = 0.25;
  constexpr double kMass = 2600.0 * kEdge * kEdge * kEdge, kInertia = kMass * kEdge * kEdge / 6.0;
  constexpr double kYoung = kModulus / (2.0 * (1.0 - kNu * kNu));
  constexpr double kShear = kModulus / (4.0 * (2.0 - kNu) * (1.0 + kNu));
  const double ratio = damping_ratio_for(kRestitution), dt = 1e-7;
  double overlap = 0.0, speed = kSpeed, angle = 0.0, before = 0.0;
  for (bool pushes = true; pushes;) {
    overlap += dt * speed;
    const double a = std::sqrt(kRadius * std::max(0.0, overlap));
    const double dashpot = ratio * 2.0 * std::sqrt(5.0 / 6.0 * 2.0 * kYoung * a * kMass);
    const double push = 4.0 / 3.0 * kYoung * a * overlap + dashpot * speed;
    pushes = push > 0.0;
    if (!pushes) break;
    const double stiffness = 8.0 * kShear * a * kRadius * kRadius, limit = kRadius * push;
    angle = angle * std::min(1.0, before / stiffness) + dt * spin;
    angle = std::clamp(angle, -limit / stiffness, limit / stiffness);
    before = stiffness;
    spin -= dt * stiffness * angle / kInertia;
    speed -= dt * push / kMass;
  }
  return spin;
}

/// LIGGGHTS' wall pulls at the end of an impact, and its torque goes on meanwhile; it takes the
/// turn of a sphere too large by (R - d/2) / (R - d), and keeps the torque as the spring softens.
TEST(WallRolling, LeavesTheSpinThatTheLawLeaves) {
  for (const double spin : {0.5, 5.0, 20.0, 40.0, 80.0}) {
    const Bounce own = bounce_on(kRolls, spin), stock = bounce_on(kStockRolls, spin);
    const double law = spin_by_the_law(spin);
    std::cout << "spin " << spin << " rad/s: " << own.spin << " after a bounce, by the law " << law
              << " (LIGGGHTS " << stock.spin << "); torque over time, of its limit's: " << own.share
              << " (LIGGGHTS " << stock.share << ")\n";
    EXPECT_NEAR(own.spin, law, 0.01 * spin);
    EXPECT_LE(own.share, 1.0);
  }
}

}  // namespace
}  // namespace muckpile::test
