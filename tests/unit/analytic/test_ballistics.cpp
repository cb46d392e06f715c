// SPDX-License-Identifier: GPL-2.0-or-later
// Ballistic range against hand-worked flights.
// Scope: level, raised and vertical launches.
#include <gtest/gtest.h>

#include <numbers>

#include "analytic/ballistics.h"
#include "args/input_error.h"

namespace muckpile {
namespace {

TEST(BallisticRange, HorizontalLaunchFallsFreely) {
  // 15.3 m/s from 10 m: t = sqrt(20/9.80665) = 1.428091 s, range 21.850 m (dossier: 21.8);
  // from 15 m: t = 1.749046 s, range 26.760 m (dossier: 26.7 with g = 9.81 and 15.3 rounded)
  EXPECT_NEAR(ballistic_range(15.3, 0.0, 10.0), 21.850, 1e-3);
  EXPECT_NEAR(ballistic_range(15.3, 0.0, 15.0), 26.760, 1e-3);
}

TEST(BallisticRange, LevelGroundAtFortyFiveDegreesIsSpeedSquaredOverG) {
  EXPECT_NEAR(ballistic_range(20.0, std::numbers::pi / 4.0, 0.0, 10.0), 40.0, 1e-12);
}

TEST(BallisticRange, VerticalLaunchComesBack) {
  EXPECT_NEAR(ballistic_time(20.0, std::numbers::pi / 2.0, 0.0, 10.0), 4.0, 1e-12);
  EXPECT_NEAR(ballistic_range(20.0, std::numbers::pi / 2.0, 0.0, 10.0), 0.0, 1e-12);
}

TEST(BallisticRange, RefusesAPitBelowGround) {
  EXPECT_THROW((void)ballistic_range(10.0, 0.0, -1.0), InputError);
  EXPECT_THROW((void)ballistic_range(-10.0, 0.0, 1.0), InputError);
}

}  // namespace
}  // namespace muckpile
