// SPDX-License-Identifier: GPL-2.0-or-later
// Where a sphere behind faces must go, and what the contact law is shown of it.
// Scope: worked by hand.
#include <gtest/gtest.h>

#include "contact/one_sided_face.h"

namespace muckpile {
namespace {

const Vec3 kUp(0, 0, 1), kLeft(-1, 0, 0);

TEST(WayOut, BallIsShownBeforeTheFaceWithItsLowestPointWhereItIs) {
  WayOut way;
  EXPECT_FALSE(way.known());
  way.consider(0.06, kUp);
  ASSERT_TRUE(way.known());
  // Centre 0.06 below z = 0, radius 0.1: the lowest point is at -0.16. Shown 0.01 * 0.1 above z =
  // 0.
  const Ball shown = way.before_face({Vec3(1, 2, -0.06), 0.1});
  EXPECT_NEAR((shown.centre - Vec3(1, 2, 0.001)).norm(), 0.0, 1e-15);
  EXPECT_NEAR(shown.radius, 0.161, 1e-15);
  EXPECT_NEAR(shown.centre.z() - shown.radius, -0.16, 1e-15);
}

TEST(WayOut, NearestFaceIsTheWayOutInAnyOrder) {
  WayOut floor_first, step_first;
  floor_first.consider(0.01, kUp);
  floor_first.consider(0.05, kLeft);
  step_first.consider(0.05, kLeft);
  step_first.consider(0.01, kUp);
  const Ball ball{Vec3(0.05, 0, -0.01), 0.1};
  for (const WayOut& way : {floor_first, step_first}) {
    const Ball shown = way.before_face(ball);
    EXPECT_NEAR((shown.centre - Vec3(0.05, 0, 0.001)).norm(), 0.0, 1e-15);
    EXPECT_NEAR(shown.radius, 0.111, 1e-15);
  }
}

}  // namespace
}  // namespace muckpile
