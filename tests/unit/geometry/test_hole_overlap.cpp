// SPDX-License-Identifier: GPL-2.0-or-later
// Which crushed zones lie in one another.
#include <gtest/gtest.h>

#include "args/input_error.h"
#include "geometry/holes/hole_overlap.h"

namespace muckpile {
namespace {

Hole upright(double x, double low, double high, double radius) {
  return {{x, 0, low}, {x, 0, high}, radius};
}

TEST(HoleOverlap, ParallelHolesOverlapBelowTheSumOfTheirRadii) {
  EXPECT_TRUE(overlap(upright(0, 0, 5, 0.4), upright(0.69, 0, 5, 0.3)));
  EXPECT_FALSE(overlap(upright(0, 0, 5, 0.4), upright(0.7, 0, 5, 0.3)));
}

TEST(HoleOverlap, DecksOfOneHoleMayTouchButNotOverlap) {
  EXPECT_FALSE(overlap(upright(0, 0, 2, 0.4), upright(0, 2.1, 4, 0.4)));
  EXPECT_FALSE(overlap(upright(0, 0, 2, 0.4), upright(0, 2, 4, 0.4)));
  EXPECT_TRUE(overlap(upright(0, 0, 2, 0.4), upright(0, 1.9, 4, 0.4)));
  EXPECT_TRUE(overlap(upright(0, 0, 2, 0.4), upright(0, 0, 2, 0.4)));
}

TEST(HoleOverlap, DirectionOfTheAxisDoesNotMatter) {
  EXPECT_TRUE(overlap(upright(0, 0, 2, 0.4), upright(0, 4, 1.9, 0.4)));
  EXPECT_FALSE(overlap(upright(0, 2, 0, 0.4), upright(0, 2.1, 4, 0.4)));
}

TEST(HoleOverlap, CrossingHolesOverlap) {
  const Hole lying{{-2, 0.5, 1}, {2, 0.5, 1}, 0.2};
  EXPECT_TRUE(overlap(upright(0, 0, 2, 0.31), lying));
  EXPECT_FALSE(overlap(upright(0, 0, 2, 0.29), lying));
  EXPECT_TRUE(overlap(upright(0, 0, 2, 0.1), {{-2, 0, 1}, {2, 0, 1}, 0.1}));
}

// The lying hole ends 0.5 m from the upright axis: only the upright one's radius counts.
TEST(HoleOverlap, AHoleThatEndsInFrontOfAnotherCountsByTheOthersRadius) {
  const Hole lying{{0.5, 0, 1}, {2, 0, 1}, 0.3};
  EXPECT_FALSE(overlap(upright(0, 0, 2, 0.45), lying));
  EXPECT_TRUE(overlap(upright(0, 0, 2, 0.55), lying));
}

TEST(HoleOverlap, NamesTheTwoHoles) {
  const std::vector<Hole> row{upright(3, 0, 1, 0.3), upright(0, 0, 1, 0.3), upright(9, 0, 1, 0.3),
                              upright(0.5, 0, 1, 0.3)};
  try {
    refuse_overlapping_holes(row);
    FAIL() << "accepted";
  } catch (const InputError& refused) {
    EXPECT_NE(std::string(refused.what()).find("holes 2 and 4 overlap"), std::string::npos)
        << refused.what();
  }
  EXPECT_NO_THROW(refuse_overlapping_holes({row[0], row[1], row[2]}));
}

}  // namespace
}  // namespace muckpile
