// SPDX-License-Identifier: GPL-2.0-or-later
// Which blocks lie in others.
// Scope: made-up rock of cubes.
#include <gtest/gtest.h>

#include <algorithm>

#include "measure/sunk_blocks.h"
#include "synthetic_run.h"

namespace muckpile {
namespace {

using namespace testing;

class RockOfCubes : public ::testing::Test {
 protected:
  [[nodiscard]] std::vector<char> sunk() const { return sunk_blocks(blocks_, last_.states); }
  const std::vector<StartBlock> blocks_ = as_start_blocks(cubes_in({0, 0, 0}, {2, 2, 2}));
  Snapshot last_ = start_snapshot(blocks_);
};

TEST_F(RockOfCubes, HasNoneAtTheStart) { EXPECT_EQ(std::ranges::count(sunk(), 1), 0); }

TEST_F(RockOfCubes, HasNoneWhereCentresStayOutside) {
  last_.states[0].centre += 0.49 * kCube * Vec3::UnitX();
  EXPECT_EQ(std::ranges::count(sunk(), 1), 0);
}

// Each of the two holds the other's centre, as they are alike.
TEST_F(RockOfCubes, CountsABlockWhoseCentreLiesInAnother) {
  last_.states[0].centre += 0.51 * kCube * Vec3::UnitX();
  EXPECT_EQ(std::ranges::count(sunk(), 1), 2);
  EXPECT_EQ(sunk()[0], 1);
}

// A corner of the turned cube reaches 0.71 of the edge out along x, its face half of it.
TEST_F(RockOfCubes, TakesBlocksAsTheyLie) {
  last_.states[0].centre = Vec3(-5.0, 0.0, 0.0);
  last_.states[1].centre = Vec3(-5.0 + 0.6 * kCube, 0.0, 0.0);
  EXPECT_EQ(std::ranges::count(sunk(), 1), 0);
  last_.states[0].rotation = Quat(Eigen::AngleAxisd(M_PI / 4.0, Vec3::UnitZ()));
  EXPECT_EQ(sunk()[0], 0);
  EXPECT_EQ(sunk()[1], 1);
}

}  // namespace
}  // namespace muckpile
