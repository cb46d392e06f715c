// SPDX-License-Identifier: GPL-2.0-or-later
// What a bench leaves beyond its old toe if it only slumps, against areas worked by hand.
// Scope: measure/collapse; slopes of 1 in 1, so that triangles are half squares.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "measure/collapse.h"

namespace muckpile {
namespace {

constexpr double kOneInOne = 0.25 * std::numbers::pi;

TEST(Collapse, OfLittleRockIsATriangleOnTheWall) {
  // 4 m x 6.4 m swollen by 1.25: 32 m2, a triangle of 8 m x 8 m. The 4 m beyond the toe hold 8 m2.
  EXPECT_NEAR(collapsed_beyond_toe({10.0, 4.0, 4.0 * 6.4, 1.25, kOneInOne}), 8.0 / 32.0, 1e-12);
}

TEST(Collapse, StopsAtTheOldToeIfTheTriangleDoes) {
  EXPECT_NEAR(collapsed_beyond_toe({10.0, 8.0, 32.0, 1.0, kOneInOne}), 0.0, 1e-12);
  EXPECT_EQ(collapsed_beyond_toe({10.0, 9.0, 32.0, 1.0, kOneInOne}), 0.0);
}

TEST(Collapse, OfMuchRockIsLevelWithTheBench) {
  // 4 m high, 5 m wide, swollen by 1.2: 24 m2 are 4 m of level rock and a triangle of 8 m2, from 1
  // m behind the toe to 3 m beyond it: 3^2 / 2 m2.
  EXPECT_NEAR(collapsed_beyond_toe({4.0, 5.0, 20.0, 1.2, kOneInOne}), 4.5 / 24.0, 1e-12);
  // By 1.4: 5 m and the triangle, which begins at the toe.
  EXPECT_NEAR(collapsed_beyond_toe({4.0, 5.0, 20.0, 1.4, kOneInOne}), 8.0 / 28.0, 1e-12);
  // By 1.6: 6 m, of which one is beyond the toe, and the triangle.
  EXPECT_NEAR(collapsed_beyond_toe({4.0, 5.0, 20.0, 1.6, kOneInOne}), 12.0 / 32.0, 1e-12);
}

TEST(Collapse, TakesTheSlopeIntoAccount) {
  // 1 in 4: 32 m2 are a triangle of 4 m x 16 m; the 12 m beyond a toe at 4 m are 9 / 16 of it.
  EXPECT_NEAR(collapsed_beyond_toe({10.0, 4.0, 32.0, 1.0, std::atan(0.25)}), 9.0 / 16.0, 1e-12);
}

TEST(Collapse, HasNoMeaningWithoutASwellOrASlope) {
  EXPECT_TRUE(std::isnan(collapsed_beyond_toe({10.0, 4.0, 32.0, std::nan(""), kOneInOne})));
  EXPECT_TRUE(std::isnan(collapsed_beyond_toe({10.0, 4.0, 32.0, 1.3, std::nan("")})));
}

}  // namespace
}  // namespace muckpile
