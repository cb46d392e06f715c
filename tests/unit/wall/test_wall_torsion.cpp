// SPDX-License-Identifier: GPL-2.0-or-later
// Spin about the normal of a wall, and rolling beside it, against closed forms.
// Scope: one sphere on level ground, at its weight.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <vector>

#include "args/input_error.h"
#include "ride_on_wall.h"

namespace muckpile::test {
namespace {

/// A top of a sphere on level ground: spin w - 2.5 mu_r g t / R with torsion, else w.
TEST(WallTorsion, TopIsSlowedByTorsionAlone) {
  const WallPlane floor = floor_plane();
  ContactParameters p = parameters();
  p.rolling_friction = 0.1;
  for (const bool torsion : {false, true}) {
    Ride ride(floor, p, Vec3(0, 0, kRadius), 1e-5, torsion);
    ride.weigh(Vec3(0, 0, -kGravity));
    ride.push_off(Vec3::Zero());
    ride.run(2.0);  // it comes to rest
    ride.push_off(Vec3::Zero(), Vec3(0, 0, 10.0));
    const double start = ride.energy(), brought = ride.kinetic();
    ride.run(1.0);
    const double theory = 10.0 - (torsion ? 2.5 * 0.1 * kGravity * 1.0 / kRadius : 0.0);
    const double error = ride.sphere().spin.z() / theory - 1.0;
    std::cout << "top: spin off by " << error << ", energy by " << (ride.energy() - start) / brought
              << "\n";
    EXPECT_NEAR(error, 0.0, torsion ? 2e-4 : 1e-12);
    EXPECT_NEAR((ride.energy() - start) / brought, 0.0, 1e-10);
    ride.run(3.0);
    if (torsion) {
      EXPECT_NEAR(ride.sphere().spin.norm(), 0.0, 0.1);  // it swings on its spring
    }
  }
}

/// Without friction nothing but the resisting torque turns the sphere. It is mu_r R N at most, for
/// rolling and spin about the normal together, and against the spin as a whole: the axis stays, and
/// the spin falls by 2.5 mu_r g t / R.
TEST(WallTorsion, RollingAndTorsionShareOneLimit) {
  const WallPlane floor = floor_plane();
  ContactParameters p = parameters();
  p.friction = 0.0;
  p.rolling_friction = 0.1;
  Ride ride(floor, p, Vec3(0, 0, kRadius), 1e-5, true);
  ride.weigh(Vec3(0, 0, -kGravity));
  ride.push_off(Vec3::Zero());
  ride.run(2.0);  // it comes to rest
  const Vec3 spin(6.0, 0.0, 8.0);
  ride.push_off(Vec3::Zero(), spin);
  const double start = ride.energy(), brought = ride.kinetic();
  ride.run(1.0);
  const Vec3 theory = (1.0 - 2.5 * 0.1 * kGravity / kRadius / spin.norm()) * spin;
  const double error = (ride.sphere().spin - theory).norm() / theory.norm();
  std::cout << "rolling and torsion: spin off by " << error << ", energy by "
            << (ride.energy() - start) / brought << "\n";
  EXPECT_LT(error, 2e-4);
  EXPECT_NEAR((ride.energy() - start) / brought, 0.0, 1e-10);
  EXPECT_NEAR(ride.now().torque.norm() / (0.1 * kRadius * kMass * kGravity), 1.0, 1e-6);
}

/// Turned to and fro below the limit: what the spring takes it gives back.
TEST(WallTorsion, SpringBelowItsLimitIsElastic) {
  const WallPlane floor = floor_plane();
  ContactParameters p = parameters();
  p.restitution = 1.0;
  p.rolling_friction = 1.0;
  const WallLaw law(p, true);
  std::vector<WallContact> contacts;
  WallSphere ball{Vec3(0, 0, 0.98 * kRadius), Vec3::Zero(), Vec3::Zero(), kRadius, kMass};
  WallTouches touches;
  floor.find_touches(ball.centre, kRadius, {}, touches);
  contacts.push_back({Vec3::UnitZ(), {}, 0.0, 0.0});
  const WallPush before = law.push(ball, touches, 1e-5, 0.0, contacts);
  double lost = 0.0, most = 0.0;
  for (int k = 0; k < 2000; ++k) {
    // The path of a whole turn of phase ends where it began.
    ball.spin = 1e-3 * std::cos(2.0 * M_PI * (k + 0.5) / 2000.0) * Vec3(1.0, 0.0, 2.0);
    const WallPush now = law.push(ball, touches, 1e-5, 1e-5, contacts);
    lost += now.friction;
    most = std::max(most, now.elastic - before.elastic);
  }
  EXPECT_GT(most, 0.0);
  EXPECT_NEAR(lost / most, 0.0, 1e-9);
  EXPECT_NEAR(contacts.front().twist, 0.0, 1e-15);
  EXPECT_NEAR(contacts.front().state.roll.norm(), 0.0, 1e-15);
}

TEST(WallTorsion, RollingFrictionBelowZeroIsRefused) {
  ContactParameters p = parameters();
  p.rolling_friction = -0.1;
  EXPECT_THROW(WallLaw(p, true), InputError);
}

}  // namespace
}  // namespace muckpile::test
