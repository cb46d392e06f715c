// SPDX-License-Identifier: GPL-2.0-or-later
// Impulses by cause: kicks of changing forces and steps, blocks that come and go between ranks.
// Scope: motion/impulse_sums; by hand.
#include <gtest/gtest.h>

#include <array>

#include "motion/impulse_sums.h"

namespace muckpile {
namespace {

constexpr std::array kBoth = {7, 4};

void push(ImpulseSums& sums, std::span<const int> tags, double force, ImpulsePart part) {
  for (ByPart& on : sums.forces_on(tags)) on[part] = force * Vec3::UnitX();
}

double pushed(const ImpulseRow& row, ImpulsePart part) { return row.impulse[part].x(); }

TEST(ImpulseSums, GiveHalfAStepToTheForcesOfEachOfItsEnds) {
  ImpulseSums sums;
  push(sums, kBoth, 10.0, ImpulsePart::wave);
  sums.begin(std::array<Vec3, 2>{Vec3(0.0, 1.0, 0.0), Vec3(0.0, 2.0, 0.0)});
  sums.kick(0.05);  // a step of 0.1 s begins
  push(sums, kBoth, 30.0, ImpulsePart::joints);
  sums.kick(0.05);
  sums.kick(0.2);  // and one of 0.4 s
  ASSERT_EQ(sums.rows().size(), 2U);
  EXPECT_EQ(sums.rows()[1].tag, 4);
  EXPECT_DOUBLE_EQ(pushed(sums.rows()[1], ImpulsePart::wave), 0.5);
  EXPECT_DOUBLE_EQ(pushed(sums.rows()[1], ImpulsePart::joints), 7.5);
  EXPECT_EQ(sums.rows()[1].impulse[ImpulsePart::before], Vec3(0.0, 2.0, 0.0));
  EXPECT_EQ(sums.rows()[1].impulse.sum(), Vec3(8.0, 2.0, 0.0));
}

TEST(ImpulseSums, RowsOfTwoRanksAddUpToABlock) {
  ImpulseSums here, there;
  push(here, kBoth, 10.0, ImpulsePart::contacts);
  here.kick(1.0);
  push(here, std::array{4}, 1.0, ImpulsePart::contacts);  // block 7 leaves
  push(there, std::array{7}, 2.0, ImpulsePart::contacts);
  here.kick(1.0);
  there.kick(1.0);
  push(here, std::array{7, 4}, 5.0, ImpulsePart::contacts);  // and comes back
  here.kick(1.0);
  std::vector<ImpulseRow> rows = there.rows();
  rows.insert(rows.end(), here.rows().begin(), here.rows().end());
  ASSERT_EQ(rows.size(), 3U);
  const std::vector<ImpulseRow> all = added_up(rows);
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].tag, 4);
  EXPECT_DOUBLE_EQ(pushed(all[0], ImpulsePart::contacts), 16.0);
  EXPECT_DOUBLE_EQ(pushed(all[1], ImpulsePart::contacts), 17.0);
}

}  // namespace
}  // namespace muckpile
