// SPDX-License-Identifier: GPL-2.0-or-later
// Springs that give way: what walls bear, what is taken for good.
// Scope: hand-worked numbers of one point; the network's energy account is in
// test_wall_strength.cpp and test_crushing_faces.cpp.
#include <gtest/gtest.h>

#include "bond/law/giving_way.h"
#include "bond/law/linear_closure.h"

namespace muckpile::test {
namespace {

constexpr double kRounding = 1e-12;

TEST(CrushingWalls, BearNoPressureBeyondTheirStrength) {
  const CrushingWalls<Lanes> walls{5e7};
  EXPECT_EQ(walls.bear(-8e7)[0], -5e7);
  EXPECT_EQ(walls.bear(-4e7)[0], -4e7);
  EXPECT_EQ(walls.bear(2e6)[0], 2e6);  // tension
}

TEST(CrushingWalls, OfFacesThatMatchByHalfBearHalf) {
  // Full faces of 1e12 Pa/m carry 5e7 Pa where they are pressed together by 5e-5 m, and halves
  // carry half of that there.
  const CrushingContact<Lanes> contact(0.5, 1e12, 5e7);
  EXPECT_NEAR(contact.deepest[0], -5e-5, 1e-17);
  EXPECT_NEAR(contact.traction(contact.deepest)[0], -2.5e7, 1e-5);
  EXPECT_NEAR(contact.walls().bear(-3e7)[0], -2.5e7, 1e-5);
}

TEST(GivingWay, TakesTheWorkOfTheMeanForceLessWhatTheSpringGains) {
  // A spring of 2 Pa/m goes from 1 m by 3 m to 4 m and is left with 2.5 m: forces of 2 and 5 Pa, so
  // (2 + 5)/2 3 = 10.5 J/m2 less 2 (2.5^2 - 1^2)/2 = 5.25 J/m2 is 5.25 J/m2, twice over 2: 5.25 m2.
  EXPECT_NEAR(twice_taken_for_good(Lanes(4.0), Lanes(2.5), Lanes(3.0))[0], 5.25, kRounding);
  EXPECT_NEAR(taken_for_good<Lanes>(2.0, 8.0, 3.0, 1.5, 3.0)[0], 5.25, kRounding);
}

TEST(GivingWay, TakesThatOfEachDirection) {
  // The same across a path that the spring does not resist: along y 1 m that stays.
  const LaneVec whole(Vec3(4.0, 1.0, 0.0)), after(Vec3(2.5, 1.0, 0.0)), path(Vec3(3.0, 0.5, 0.0));
  EXPECT_NEAR(twice_taken_for_good(whole, after, path)[0], 5.25, kRounding);
  const Lanes stiffness = 2.0;
  EXPECT_NEAR(taken_for_good(stiffness, stiffness * whole, stiffness * (whole - after),
                             whole - after, path)[0],
              5.25, kRounding);
}

TEST(GivingWay, ThatShedsLessThanIsOverTakesOnlyWhatSpringAndBlocksLose) {
  // 8 Pa of which 3 are over, but the spring gives way by 0.5 m, which sheds 1 Pa: it loses 0.5 (8
  // + 7)/2 = 3.75 J/m2, of which the blocks keep the 3 - 1/2 = 2.5 Pa that are missing over 1 m.
  EXPECT_NEAR(taken_for_good<Lanes>(2.0, 8.0, 3.0, 0.5, 1.0)[0], 3.75 - 2.5, kRounding);
}

}  // namespace
}  // namespace muckpile::test
