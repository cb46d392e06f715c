// SPDX-License-Identifier: GPL-2.0-or-later
// Motion given to bodies: what takes the place of what, turning about an axis, pushes beside the
// centre.
// Scope: numbers worked by hand.
#include <gtest/gtest.h>

#include "motion/given_motion.h"

namespace muckpile {
namespace {

/// 2 kg at (1, 0, 0); moments 1, 2 and 4 kg m2.
MovingBody a_body() {
  MovingBody body;
  body.mass = 2.0;
  body.inertia = Vec3(1, 2, 4).asDiagonal();
  body.centre = Vec3(1, 0, 0);
  body.velocity = Vec3(3, 0, 0);
  body.spin = Vec3(0, 0, 1);
  return body;
}

TEST(GivenMotion, WhatIsNotGivenStays) {
  GivenMotion given;
  given.velocity = Vec3(0, 5, 0);
  const MovingBody body = moved(a_body(), given);
  EXPECT_EQ(body.velocity, Vec3(0, 5, 0));
  EXPECT_EQ(body.spin, Vec3(0, 0, 1));
  EXPECT_EQ(body.kinetic_energy(), 0.5 * 2.0 * 25.0 + 0.5 * 4.0 * 1.0);
}

TEST(GivenMotion, IsAddedWhereAskedFor) {
  GivenMotion given;
  given.velocity = Vec3(0, 5, 0);
  given.spin = Vec3(0, 0, 2);
  given.adds = true;
  const MovingBody body = moved(a_body(), given);
  EXPECT_EQ(body.velocity, Vec3(3, 5, 0));
  EXPECT_EQ(body.spin, Vec3(0, 0, 3));
}

// (0, 0, 2) x ((1, 0, 0) - (0, 1, 0)) = (2, 2, 0)
TEST(GivenMotion, RotationTurnsTheBodyAlongWithItsPath) {
  GivenMotion given;
  given.velocity = Vec3(0, 0, 1);
  given.rotation = Vec3(0, 0, 2);
  given.origin = Vec3(0, 1, 0);
  const MovingBody body = moved(a_body(), given);
  EXPECT_EQ(body.velocity, Vec3(2, 2, 1));
  EXPECT_EQ(body.spin, Vec3(0, 0, 2));
}

// 6 N s / 2 kg = 3 m/s. Through (1, 0.5, 0): (0, 0.5, 0) x (6, 0, 0) = (0, 0, -3) N m s, over 4
// kg m2: -0.75 rad/s.
TEST(GivenMotion, PushBesideTheCentreSpins) {
  GivenMotion given;
  given.impulse = Vec3(6, 0, 0);
  MovingBody body = moved(a_body(), given);
  EXPECT_EQ(body.velocity, Vec3(6, 0, 0));
  EXPECT_EQ(body.spin, Vec3(0, 0, 1));
  given.at = Vec3(1, 0.5, 0);
  body = moved(a_body(), given);
  EXPECT_EQ(body.velocity, Vec3(6, 0, 0));
  EXPECT_EQ(body.spin, Vec3(0, 0, 0.25));
}

}  // namespace
}  // namespace muckpile
