// SPDX-License-Identifier: GPL-2.0-or-later
// Fragments and their size curve, against sums done by hand.
// Scope: measure/fragments.
#include <gtest/gtest.h>

#include <cmath>

#include "measure/fragments.h"
#include "synthetic_run.h"

namespace muckpile {
namespace {

using namespace testing;

TEST(PassingCurve, AddsTheMassOfEqualSizesAndEndsAtOne) {
  const auto curve =
      passing_curve({{2.0, 30.0}, {0.5, 10.0}, {1.0, 20.0}, {0.5, 10.0}, {1.0, 30.0}});
  ASSERT_EQ(curve.size(), 3U);
  EXPECT_DOUBLE_EQ(curve[0].size, 0.5);
  EXPECT_DOUBLE_EQ(curve[0].passing, 0.2);
  EXPECT_DOUBLE_EQ(curve[1].passing, 0.7);
  EXPECT_DOUBLE_EQ(curve[2].passing, 1.0);
}

TEST(PassingCurve, GivesSizesOnStraightLinesBetweenItsPoints) {
  const auto curve = passing_curve({{0.5, 20.0}, {1.0, 50.0}, {2.0, 30.0}});
  EXPECT_DOUBLE_EQ(size_at(curve, 0.1), 0.5);  // below the first point
  EXPECT_DOUBLE_EQ(size_at(curve, 0.2), 0.5);
  EXPECT_NEAR(size_at(curve, 0.5), 0.5 + 0.5 * 0.3 / 0.5, 1e-12);
  EXPECT_NEAR(size_at(curve, 0.85), 1.5, 1e-12);
  EXPECT_DOUBLE_EQ(size_at(curve, 1.0), 2.0);
  EXPECT_TRUE(std::isnan(size_at({}, 0.5)));
}

// A third is of 1 m, two thirds are of 2 m, but for rounding or not: P50 lies on the way to the
// first of the two pieces, 1 + (1/2 - 1/3)/(1/3), P80 is 2 m.
TEST(PassingCurve, HasOnePointOfSizesThatDifferByRounding) {
  const double rounded = std::nextafter(2.0, 3.0), millionth = 2.0 * (1.0 + 3e-6);
  const auto curve = passing_curve({{2.0, 10.0}, {1.0, 10.0}, {rounded, 10.0}});
  ASSERT_EQ(curve.size(), 2U);
  EXPECT_DOUBLE_EQ(curve[1].size, rounded);
  for (const auto& same : {curve, passing_curve({{2.0, 10.0}, {1.0, 10.0}, {2.0, 10.0}})}) {
    EXPECT_NEAR(size_at(same, 0.5), 1.5, 1e-12);
    EXPECT_NEAR(size_at(same, 0.8), 2.0, 1e-12);
  }
  EXPECT_EQ(passing_curve({{2.0, 10.0}, {1.0, 10.0}, {millionth, 10.0}}).size(), 3U);
}

TEST(Fragments, GroupBlocksByTheirFragmentNumber) {
  const auto blocks = as_start_blocks(
      {cube_at({0, 0, 0}), cube_at({0.5, 0, 0}), cube_at({5, 0, 0}), cube_at({9, 0, 0})});
  Snapshot s = start_snapshot(blocks);
  s.states[1].fragment = 1;
  s.states[0].centre.x() += 8.0;
  s.states[1].centre.x() += 8.0;
  s.states[2].centre.z() += 3.0;
  const auto fragments = fragments_of(blocks, s, {1, 1, 1, 0});
  ASSERT_EQ(fragments.size(), 3U);
  EXPECT_EQ(fragments[0].id, 1);
  EXPECT_EQ(fragments[0].blocks, 2);
  EXPECT_NEAR(fragments[0].size, std::cbrt(0.25), 1e-12);
  EXPECT_NEAR(fragments[0].mass, 0.25 * kDensity, 1e-9);
  EXPECT_NEAR((fragments[0].last - fragments[0].start).norm(), 8.0, 1e-12);
  EXPECT_TRUE(fragments[1].in_pile);
  EXPECT_FALSE(fragments[2].in_pile);
}

TEST(Fragments, OfOneBlockHaveAShareOfThePilesMass) {
  const auto blocks = as_start_blocks(
      {cube_at({0, 0, 0}), cube_at({1, 0, 0}), cube_at({2, 0, 0}), cube_at({3, 0, 0})});
  Snapshot s = start_snapshot(blocks);
  s.states[1].fragment = 1;
  // Two blocks hold together, one is single, one stayed: a third of the pile.
  EXPECT_NEAR(single_block_share(fragments_of(blocks, s, {1, 1, 1, 0})), 1.0 / 3.0, 1e-12);
  EXPECT_TRUE(std::isnan(single_block_share(fragments_of(blocks, s, {0, 0, 0, 0}))));
}

TEST(Fragments, AreInThePileWhenMostOfTheirMassMoved) {
  const auto blocks = as_start_blocks({cube_at({0, 0, 0}), cube_at({1, 0, 0}), cube_at({2, 0, 0})});
  Snapshot s = start_snapshot(blocks);
  for (BlockState& state : s.states) state.fragment = 1;
  EXPECT_FALSE(fragments_of(blocks, s, {1, 0, 0})[0].in_pile);
  EXPECT_TRUE(fragments_of(blocks, s, {1, 1, 0})[0].in_pile);
}

}  // namespace
}  // namespace muckpile
