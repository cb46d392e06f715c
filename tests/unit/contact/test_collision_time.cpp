// SPDX-License-Identifier: GPL-2.0-or-later
// Hertz' collision time against numbers worked by hand.
// Scope: the law alone; a collision that is integrated takes as long in test_contact_law.cpp.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "contact/collision_time.h"

namespace muckpile {
namespace {

TEST(CollisionTime, OfTwoBallsByHand) {
  // m^2 / (R E*^2 v) = 2^2 / (0.01 * (1e6)^2 * 12.8) = 3.125e-11 s^5 = 1e-9 / 32 s^5.
  const double root = 0.5 * std::pow(10.0, -9.0 / 5.0);  // s
  EXPECT_NEAR(hertz_collision_time({2.0, 0.01, 1e6, 12.8}), 2.87 * root, 1e-12);
}

TEST(CollisionTime, IsThatOfAnIntegratedCollision) {
  // m x'' = -4/3 E* sqrt(R) x^(3/2) from x = 0 with x' = v until x = 0; the coefficient 2.87 is
  // rounded from 2.943 (15/16)^(2/5) = 2.868.
  const Collision c{2.0, 0.01, 1e6, 12.8};
  const double stiffness = 4.0 / 3.0 * c.effective_modulus * std::sqrt(c.reduced_radius);
  double x = 0.0, v = c.speed, time = 0.0;
  constexpr double kStep = 1e-7;  // s, a 200,000th of the collision
  do {
    v -= kStep * stiffness * std::pow(std::max(x, 0.0), 1.5) / c.reduced_mass;
    x += kStep * v;
    time += kStep;
  } while (x > 0.0);
  EXPECT_NEAR(hertz_collision_time(c) / time, 1.0, 1e-3);
}

TEST(CollisionTime, FallsWithTheFifthRootOfTheSpeed) {
  const Collision slow{2.0, 0.01, 1e6, 1.0}, fast{2.0, 0.01, 1e6, 32.0};
  EXPECT_NEAR(hertz_collision_time(slow) / hertz_collision_time(fast), 2.0, 1e-12);
}

TEST(CollisionTime, OfTheSmallestBlocksOfTheBench) {
  // Mass 0.5 * 2700 * 0.18^3 = 7.873 kg, reduced 3.937 kg; radius 0.036 m, reduced 0.018 m;
  // E* = 2.5e7 / (2 * 0.9375) = 1.333e7 Pa; at 20 m/s 2.87 (15.50 / 6.4e13)^(1/5) = 8.60 ms.
  const SmallBlocks blocks{0.18, 2700.0, 5, 2.5e7 / 1.875};
  EXPECT_NEAR(collision_time_of(blocks, 20.0), 8.604e-3, 1e-6);
}

TEST(CollisionTime, OfPolyhedraDoesNotDependOnTheSpeed) {
  // The same reduced mass, on faces of stiffness 2 * 1.333e7 Pa * 0.18 m = 4.8e6 N/m:
  // pi sqrt(3.937 / 4.8e6) = 2.845 ms.
  const SmallBlocks blocks{0.18, 2700.0, 5, 2.5e7 / 1.875, true};
  EXPECT_NEAR(collision_time_of(blocks, 20.0), 2.845e-3, 1e-6);
  EXPECT_EQ(collision_time_of(blocks, 1.0), collision_time_of(blocks, 20.0));
}

TEST(CollisionTime, IsShorterWhereManySpheresTouchAtOnce) {
  EXPECT_EQ(crowd_factor(1), 1.0);
  EXPECT_EQ(crowd_factor(5), 1.0);
  EXPECT_NEAR(crowd_factor(40), 2.0, 1e-12);  // (40/5)^(1/3)
  const SmallBlocks few{0.18, 2700.0, 5, 1.3e7}, many{0.18, 2700.0, 40, 1.3e7};
  EXPECT_NEAR(collision_time_of(few, 20.0) / collision_time_of(many, 20.0), 2.0, 1e-12);
}

}  // namespace
}  // namespace muckpile
