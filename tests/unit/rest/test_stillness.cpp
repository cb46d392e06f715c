// SPDX-License-Identifier: GPL-2.0-or-later
// When a block counts as still: it stays near one place, for a time, and is slow.
// Scope: one block, moved by hand.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <functional>

#include "rest/stillness.h"

namespace muckpile {
namespace {

const StillnessLimits kLimits{0.005, 0.2, 0.1};  // [m], [s], [m/s]

BlockPlace at(double x, double angle = 0.0, double speed = 0.0) {
  return {Vec3(x, 0.0, 0.0), Eigen::AngleAxisd(angle, Vec3::UnitZ()).toRotationMatrix(), 0.5,
          speed};
}

/// Time at which a block that moves by this rule is still for the first time within 10 s, or -1.
double first_still(const std::function<BlockPlace(double)>& rule) {
  Stillness stay;
  for (int k = 0; k <= 10000; ++k) {
    const double t = 1e-3 * k;
    if (stay.follow(kLimits, rule(t), t)) return t;
  }
  return -1.0;
}

TEST(Stillness, ComesAfterTheTimeAtOnePlace) {
  EXPECT_NEAR(first_still([](double) { return at(1.0); }), 0.2, 1.5e-3);
}

TEST(Stillness, NeverComesToABlockThatCreepsFasterThanDistancePerTime) {
  EXPECT_LT(first_still([](double t) { return at(0.030 * t); }), 0.0);  // 0.005 m / 0.2 s = 0.025
  EXPECT_NEAR(first_still([](double t) { return at(0.024 * t); }), 0.2, 1.5e-3);
}

TEST(Stillness, NeverComesToABlockThatSpeedsUp) {
  const double least = 2.0 * 0.005 / (0.2 * 0.2);  // 0.25 m/s2
  EXPECT_LT(first_still([&](double t) { return at(0.5 * 1.05 * least * t * t); }), 0.0);
  EXPECT_GT(first_still([&](double t) { return at(0.5 * 0.95 * least * t * t); }), 0.0);
}

// Up and back within the time: it stays within the distance d of where it is seen first at most for
// (2 + sqrt 2) sqrt(d/a), from the farthest it can come in from to as far beyond.
TEST(Stillness, NeverComesToABlockThatTurnsBackSharply) {
  const double bound = std::pow(2.0 + std::sqrt(2.0), 2) * 0.005 / (0.2 * 0.2);  // 1.5 m/s2
  for (const double speed : {0.05, 0.1, 0.15, 0.2, 0.25}) {
    const double a = 1.05 * bound;
    const auto flight = [&](double t) {
      return at(speed * t - 0.5 * a * t * t, 0.0, 0.0);  // as if slow: the distance alone counts
    };
    EXPECT_LT(first_still(flight), 0.0) << speed;
  }
  const double mild = 0.8;  // [m/s2], beyond 2 d/T^2, but it turns back
  EXPECT_GT(first_still([&](double t) { return at(0.0885 * t - 0.5 * mild * t * t); }), 0.0);
}

TEST(Stillness, CountsTurningAtTheRadius) {
  EXPECT_LT(first_still([](double t) { return at(0.0, 0.06 * t); }), 0.0);  // 0.5 m: 0.030 m/s
  EXPECT_GT(first_still([](double t) { return at(0.0, 0.04 * t); }), 0.0);
}

TEST(Stillness, EndsAtOnceWhenTheBlockIsFast) {
  Stillness stay;
  for (int k = 0; k <= 300; ++k) stay.follow(kLimits, at(0.0), 1e-3 * k);
  EXPECT_TRUE(stay.follow(kLimits, at(0.0), 0.301));
  EXPECT_FALSE(stay.follow(kLimits, at(0.0, 0.0, 0.11), 0.302));
  EXPECT_FALSE(stay.follow(kLimits, at(0.0), 0.303));
  EXPECT_FALSE(stay.follow(kLimits, at(std::nan("")), 0.6)) << "a place that is no number";
}

}  // namespace
}  // namespace muckpile
