// SPDX-License-Identifier: GPL-2.0-or-later
// The tree over charge axes finds what a look at every axis finds.
// Scope: random axes, points near and far; lengths in metres.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "geometry/index/axis_index.h"
#include "math/random.h"

namespace muckpile {
namespace {

Vec3 random_point(Random& random, double edge) {
  const double x = random.uniform(), y = random.uniform(), z = random.uniform();
  return edge * Vec3(x, y, z);
}

std::vector<Axis> random_axes(int count) {
  Random random(11);
  std::vector<Axis> axes;
  for (int k = 0; k < count; ++k) {
    const Vec3 from = random_point(random, 100.0);
    axes.emplace_back(from, from + random_point(random, 10.0));
  }
  return axes;
}

TEST(Axis, DistanceIsThatOfTheNearestPointOfTheSegment) {
  const Axis axis(Vec3(0.0, 0.0, 1.0), Vec3(0.0, 0.0, 3.0));
  EXPECT_DOUBLE_EQ(axis.distance(Vec3(0.5, 0.0, 2.0)), 0.5);
  EXPECT_DOUBLE_EQ(axis.distance(Vec3(3.0, 0.0, 7.0)), 5.0);   // 4 m above the upper end
  EXPECT_DOUBLE_EQ(axis.distance(Vec3(0.0, 4.0, -2.0)), 5.0);  // 3 m below the lower end
}

TEST(AxisIndex, NearestIsToTheBitThatOfALookAtEveryAxis) {
  for (const int count : {1, 2, 3, 17, 200}) {
    const std::vector<Axis> axes = random_axes(count);
    const AxisIndex index(axes);
    Random random(5);
    for (int k = 0; k < 500; ++k) {
      const Vec3 point = random_point(random, 130.0);
      double nearest = std::numeric_limits<double>::infinity();
      for (const Axis& axis : axes) nearest = std::min(nearest, axis.distance(point));
      ASSERT_EQ(index.nearest(point), nearest) << count << " axes, point " << k;
    }
  }
}

TEST(AxisIndex, NoAxisWithinTheDistanceIsMissedAndFewAreOfferedBesides) {
  const std::vector<Axis> axes = random_axes(200);
  const AxisIndex index(axes);
  Random random(6);
  std::size_t offered = 0, within = 0;
  for (int k = 0; k < 500; ++k) {
    const Vec3 point = random_point(random, 100.0);
    std::vector<int> found;
    EXPECT_FALSE(index.any_within(point, 20.0, [&](int axis) {
      found.push_back(axis);
      return false;
    }));
    offered += found.size();
    for (int a = 0; a < 200; ++a) {
      if (axes[static_cast<std::size_t>(a)].distance(point) > 20.0) continue;
      ++within;
      EXPECT_EQ(std::count(found.begin(), found.end(), a), 1) << "axis " << a;
    }
  }
  EXPECT_GT(within, 500u);
  EXPECT_LT(offered, 3 * within);
}

TEST(AxisIndex, WithoutAxesNothingIsNear) {
  const AxisIndex none({});
  EXPECT_EQ(none.nearest(Vec3::Zero()), std::numeric_limits<double>::infinity());
  EXPECT_FALSE(none.any_within(Vec3::Zero(), 1e9, [](int) { return true; }));
}

}  // namespace
}  // namespace muckpile
