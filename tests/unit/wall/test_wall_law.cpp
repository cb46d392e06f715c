// SPDX-License-Identifier: GPL-2.0-or-later
// A sphere that bounces, slides and rolls on a wall, against closed forms; its energy account.
// Scope: one sphere, stepped as LIGGGHTS does (leapfrog; forces see the velocities between steps).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <vector>

#include "flat_mesh.h"
#include "ride_on_wall.h"
#include "wall/wall_mesh.h"

namespace muckpile::test {
namespace {

double rebound(const ContactParameters& p, double speed) {
  const WallPlane floor = floor_plane();
  Ride ride(floor, p, Vec3(0, 0, kRadius + 1e-6), 2e-6);
  ride.push_off(Vec3(0, 0, -speed));
  do ride.step();
  while (ride.now().contacts > 0 || ride.sphere().velocity.z() < 0.0);
  return ride.sphere().velocity.z() / speed;
}

TEST(WallLaw, HeadOnImpactGivesTheRestitutionAskedFor) {
  double worst = 0.0;
  for (const NormalModel model : {NormalModel::hertz, NormalModel::linear}) {
    for (const double restitution : {0.1, 0.5, 0.9, 1.0}) {
      for (const double speed : {0.5, 10.0}) {
        ContactParameters p = parameters();
        p.model = model;
        p.restitution = restitution;
        worst = std::max(worst, std::abs(rebound(p, speed) / restitution - 1.0));
      }
    }
  }
  std::cout << "restitution: largest error " << worst << "\n";
  EXPECT_LT(worst, 1e-3);  // of some 2000 steps per impact
}

/// Hertz: duration 2.868 (m^2 / (R E*^2 v))^(1/5), with E* = E / (2 (1 - nu^2)) of two rocks.
TEST(WallLaw, ImpactLastsAsLongAsHertzSays) {
  ContactParameters p = parameters();
  p.restitution = 1.0;
  const double dt = 1e-6, speed = 2.0;
  const WallPlane floor = floor_plane();
  Ride ride(floor, p, Vec3(0, 0, kRadius), dt);
  ride.push_off(Vec3(0, 0, -speed));
  int steps = 0;
  do ride.step(), ++steps;
  while (ride.now().contacts > 0);
  const double star = 1e8 / (2.0 * (1.0 - 0.25 * 0.25));
  const double theory = 2.8683 * std::pow(kMass * kMass / (kRadius * star * star * speed), 0.2);
  std::cout << "duration: error " << steps * dt / theory - 1.0 << "\n";
  EXPECT_NEAR(steps * dt / theory, 1.0, 2e-4);
}

/// The linear spring against a wall: E pi R.
TEST(WallLaw, LinearSpringIsThatOfABarOfTheRadius) {
  ContactParameters p = parameters();
  p.model = NormalModel::linear;
  const WallPlane floor = floor_plane();
  Ride ride(floor, p, Vec3(0, 0, kRadius + 1e-8), 1e-6);
  ride.push_off(Vec3(0, 0, -1e-3));
  ride.run(1e-4);
  const double overlap = kRadius - ride.sphere().centre.z();
  EXPECT_NEAR(ride.now().elastic, 0.5 * 1e8 * M_PI * kRadius * overlap * overlap,
              1e-9 * ride.now().elastic);
}

/// Stiffness for the time step against the slope of the energy, by differences.
TEST(WallLaw, StiffnessForTheTimeStepIsThatOfThePush) {
  const WallPlane floor = floor_plane();
  for (const NormalModel model : {NormalModel::hertz, NormalModel::linear}) {
    ContactParameters p = parameters();
    p.model = model;
    const WallLaw law(p);
    const WallSphere still{Vec3::Zero(), Vec3::Zero(), Vec3::Zero(), kRadius, kMass};
    const auto force_at = [&](double overlap) {
      WallTouches touches;
      floor.find_touches(Vec3(0, 0, kRadius - overlap), kRadius, {}, touches);
      std::vector<WallContact> contacts{{Vec3::UnitZ(), {}, 0.0, 0.0}};
      return law.push(still, touches, 1e-6, 0.0, contacts).force.z();
    };
    const double overlap = 0.02, h = 1e-6;
    const double slope = (force_at(overlap + h) - force_at(overlap - h)) / (2.0 * h);
    const WallContact contact{Vec3::UnitZ(), {}, 0.0, overlap};
    const double error = law.resistance(still, contact).normal_stiffness / slope - 1.0;
    std::cout << "stiffness: error " << error << "\n";
    EXPECT_NEAR(error, 0.0, 1e-9);
    EXPECT_NEAR(WallLaw::arm(kRadius, contact).z(), -kRadius + 0.5 * overlap, 1e-15);
  }
}

/// A fifth of sqrt(m / k), k at an overlap of 5 % of the radius.
TEST(WallLaw, LightStepIsAFifthOfTheTimeScaleOfItsContact) {
  for (const NormalModel model : {NormalModel::hertz, NormalModel::linear}) {
    ContactParameters p = parameters();
    p.model = model;
    const WallLaw law(p);
    const WallSphere still{Vec3::Zero(), Vec3::Zero(), Vec3::Zero(), kRadius, kMass};
    const WallContact contact{Vec3::UnitZ(), {}, 0.0, 0.05 * kRadius};
    const double stiffness = law.resistance(still, contact).normal_stiffness;
    EXPECT_NEAR(law.light_step(kMass, kRadius) / (0.2 * std::sqrt(kMass / stiffness)), 1.0, 1e-12);
  }
}

TEST(WallLaw, GroundTenTimesAsStiffIsSpringsInARow) {
  EXPECT_NEAR(modulus_against(1e8, 1e9), 2.0 / (1e-8 + 1e-9), 1.0);
  EXPECT_NEAR(modulus_against(3e7, 3e7), 3e7, 1e-3);
}

/// Speed after one second down a slope of so many degrees, from rest on it [m/s].
double speed_down(const WallSurface& floor, double slope, const ContactParameters& p, bool turns) {
  const double a = slope * M_PI / 180.0, dt = 2e-5;
  Ride ride(floor, p, Vec3(-0.9, 0.1, kRadius), dt);
  ride.let_turn(turns);
  ride.weigh(kGravity * Vec3(std::sin(a), 0, -std::cos(a)));
  ride.push_off(Vec3::Zero());
  ride.run(1.0);
  return ride.sphere().velocity.x();
}

TEST(WallLaw, BlockSlidesDownASlopeAsCoulombSays) {
  const WallPlane floor = floor_plane();
  const double a = 35.0 * M_PI / 180.0;
  const double theory = kGravity * (std::sin(a) - 0.5 * std::cos(a));
  const double error = speed_down(floor, 35.0, parameters(), false) / theory - 1.0;
  std::cout << "sliding: error " << error << "\n";
  EXPECT_NEAR(error, 0.0, 3e-9);  // friction is the same share of each push
}

TEST(WallLaw, BlockSticksOnASlopeBelowTheAngleOfFriction) {
  const WallPlane floor = floor_plane();
  EXPECT_NEAR(speed_down(floor, 25.0, parameters(), false), 0.0, 1e-6);  // tan 25 = 0.47
}

/// A solid sphere rolls on R less half of its overlap d: g sin a / (1 + 0.4 R^2 / (R - d / 2)^2),
/// d = (3 F / (4 E* sqrt(R)))^(2/3).
TEST(WallLaw, SphereRollsDownASlope) {
  const WallPlane floor = floor_plane();
  const double a = 20.0 * M_PI / 180.0, star = 1e8 / (2.0 * (1.0 - 0.25 * 0.25));
  const double force = kMass * kGravity * std::cos(a);
  const double overlap = std::pow(0.75 * force / (star * std::sqrt(kRadius)), 2.0 / 3.0);
  const double ratio = kRadius / (kRadius - 0.5 * overlap);
  const double theory = kGravity * std::sin(a) / (1.0 + 0.4 * ratio * ratio);
  const double error = speed_down(floor, 20.0, parameters(), true) / theory - 1.0;
  std::cout << "rolling: error " << error << "\n";
  EXPECT_NEAR(error, 0.0, 5e-5);
}

/// Over some hundred inner edges of uneven triangles.
TEST(WallLaw, SphereFeelsNoBumpOnTheEdgesOfAFlatFloor) {
  const WallPlane plane = floor_plane();
  const WallMesh mesh(uneven_floor(20.0, 200, 4));
  double bump = 0.0, apart = 0.0;
  std::vector<Ride> rides;
  for (const WallSurface* wall : std::initializer_list<const WallSurface*>{&plane, &mesh}) {
    rides.emplace_back(*wall, parameters(), Vec3(-15, 0.3, kRadius), 5e-5);
    rides.back().weigh(Vec3(0, 0, -kGravity));
    rides.back().push_off(Vec3(9, 2, 0), Vec3(0, 5, 0));
  }
  for (int k = 0; k < 60000; ++k) {
    for (Ride& ride : rides) ride.step();
    bump = std::max(bump, (rides[0].now().force - rides[1].now().force).norm());
    apart = std::max(apart, (rides[0].sphere().centre - rides[1].sphere().centre).norm());
  }
  EXPECT_GT(rides[1].sphere().centre.x(), 5.0);
  std::cout << "flat mesh: force off by " << bump / (kMass * kGravity) << " of the weight, path by "
            << apart << " m\n";
  EXPECT_LT(bump, 1e-9 * kMass * kGravity);
  EXPECT_LT(apart, 1e-10);
}

/// Thrown into a trough with friction: bounces, slides, spins and comes to lie in its valley.
TEST(WallLaw, EnergyOfARideIsAccountedFor) {
  std::vector<StlTriangle> trough;
  add_panel(trough, {-8, -8, 3}, {0, -8, 0}, {0, 8, 0}, {-8, 8, 3});
  add_panel(trough, {0, -8, 0}, {8, -8, 5}, {8, 8, 5}, {0, 8, 0});
  const WallMesh wall(trough);
  for (const double restitution : {1.0, 0.5}) {
    ContactParameters p = parameters();
    p.restitution = restitution;
    p.rolling_friction = 0.1;
    Ride ride(wall, p, Vec3(-3, -3, 3), 1e-5);
    ride.weigh(Vec3(0, 0, -kGravity));
    ride.push_off(Vec3(2, 1, 0), Vec3(1, 4, -2));
    const double start = ride.energy(), fall = kMass * kGravity * 3.0;
    double worst = 0.0;
    for (int k = 0; k < 400000; ++k) {
      ride.step();
      worst = std::max(worst, std::abs(ride.energy() - start) / fall);
    }
    std::cout << "ride, restitution " << restitution << ": balance error " << worst << "\n";
    EXPECT_LT(worst, restitution == 1.0 ? 1e-5 : 1e-3);  // dashpots lag half a step
    EXPECT_GT(ride.friction(), 0.05 * fall);
  }
}

/// A sphere on the crest between faces: without friction it keeps its energy on edges, too.
TEST(WallLaw, SmoothSphereKeepsItsEnergyOverRidgesAndTips) {
  std::vector<StlTriangle> roof;
  for (int k = 0; k < 12; ++k) {
    const double x = -6.0 + k, low = k % 2 == 0 ? 0.0 : 0.35, high = 0.35 - low;
    add_panel(roof, {x, -4, low}, {x + 1, -4, high}, {x + 1, 4, high}, {x, 4, low});
  }
  const WallMesh wall(roof);
  ContactParameters p = parameters();
  p.restitution = 1.0;
  p.friction = 0.0;
  Ride ride(wall, p, Vec3(-4.7, 0.1, 1.2), 5e-6);
  ride.weigh(Vec3(0, 0, -kGravity));
  ride.push_off(Vec3(3, 0.1, 0));
  const double start = ride.energy(), scale = ride.kinetic();
  double worst = 0.0;
  for (int k = 0; k < 500000 && std::abs(ride.sphere().centre.x()) < 5.5; ++k) {
    ride.step();
    worst = std::max(worst, std::abs(ride.energy() - start) / scale);
  }
  std::cout << "smooth ride over ridges: energy off by " << worst << "\n";
  EXPECT_LT(worst, 4e-7);
}

}  // namespace
}  // namespace muckpile::test
