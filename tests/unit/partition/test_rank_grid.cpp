// SPDX-License-Identifier: GPL-2.0-or-later
// Grid of ranks: along the row while slabs stay thick enough, then along the throw.
#include <gtest/gtest.h>

#include "partition/rank_grid.h"

namespace muckpile {
namespace {

void expect_grid(int ranks, double width, int along_x, int along_y) {
  const RankGrid grid = rank_grid(ranks, width, 1.5);
  EXPECT_EQ(grid.along_x, along_x) << ranks << " ranks, " << width << " m";
  EXPECT_EQ(grid.along_y, along_y) << ranks << " ranks, " << width << " m";
}

TEST(RankGrid, TakesTheRowWhileSlabsAreThickEnough) {
  expect_grid(1, 3.75, 1, 1);
  expect_grid(2, 3.75, 1, 2);  // 1.875 m each
  expect_grid(2, 3.0, 1, 2);   // 1.5 m, just enough
  expect_grid(16, 60.0, 1, 16);
}

TEST(RankGrid, TakesTheThrowForTheRest) {
  expect_grid(4, 3.75, 2, 2);  // 4 along y would be 0.94 m
  expect_grid(6, 3.75, 3, 2);
  expect_grid(12, 7.0, 3, 4);  // 1.75 m; 6 would be 1.17 m
  expect_grid(7, 3.75, 7, 1);  // a prime number has no other divisor
  expect_grid(2, 2.9, 2, 1);
}

}  // namespace
}  // namespace muckpile
