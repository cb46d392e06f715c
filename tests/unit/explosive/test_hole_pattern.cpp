// SPDX-License-Identifier: GPL-2.0-or-later
// Hole tables made from rows, angles and delays: places, chambers and firing times by hand.
// Scope: core only; the table is read back by HoleTable.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <numbers>
#include <sstream>

#include "explosive/hole_pattern.h"
#include "explosive/hole_table.h"
#include "input_error_of.h"

namespace muckpile {
namespace {

// The plan of all tests; `more` wins.
HolePattern pattern(const std::string& more) {
  std::istringstream in(more);
  std::vector<std::string> words{std::istream_iterator<std::string>(in), {}};
  const std::map<std::string, std::string> usual{{"file", "f.csv"}, {"burden", "3"},
                                                 {"spacing", "4"},  {"bench_height", "10"},
                                                 {"stemming", "2"}, {"hole_diameter", "0.1"}};
  for (const auto& [name, value] : usual) {
    if (std::ranges::find(words, name) == words.end()) words.insert(words.end(), {name, value});
  }
  return hole_pattern(parse_args(hole_pattern_table(), "hole_pattern", words), "hole_pattern");
}

HoleTable table(const std::string& more) {
  return HoleTable(CsvTable::parse(hole_table_text(pattern(more)), "f.csv"));
}

std::string fault(const std::string& more) {
  return input_error_of([&] { (void)pattern(more); });
}

void expect_at(const Vec3& point, double x, double y, double z) {
  EXPECT_LT((point - Vec3(x, y, z)).norm(), 2e-9) << point.transpose();
}

TEST(HolePattern, UprightHolesStandABurdenApart) {
  const HoleTable holes = table("rows 2 holes_per_row 3 subdrill 1 stagger 0");
  ASSERT_EQ(holes.decks().size(), 6u);
  EXPECT_EQ(holes.decks()[0].hole, "r1h1");
  EXPECT_EQ(holes.decks()[5].hole, "r2h3");
  expect_at(holes.decks()[0].hole_collar, -3, -4, 10);
  expect_at(holes.decks()[0].hole_toe, -3, -4, -1);
  expect_at(holes.decks()[0].collar, -3, -4, 8);  // 2 m of stemming
  expect_at(holes.decks()[5].hole_toe, -6, 4, -1);
}

TEST(HolePattern, StaggerMovesEverySecondRowAndKeepsTheMiddle) {
  const HoleTable holes = table("rows 3 holes_per_row 2 stagger 0.5");
  // Half of 4 m, a quarter to each side: -2 - 1, -2 + 1, -2 - 1.
  EXPECT_DOUBLE_EQ(holes.decks()[0].hole_toe.y(), -3.0);
  EXPECT_DOUBLE_EQ(holes.decks()[2].hole_toe.y(), -1.0);
  EXPECT_DOUBLE_EQ(holes.decks()[4].hole_toe.y(), -3.0);
  EXPECT_DOUBLE_EQ(table("rows 1 holes_per_row 2").decks()[0].hole_toe.y(), -2.0);
}

TEST(HolePattern, LeaningHolesAreTheBurdenBehindTheToeAtTheFloor) {
  // 45 degrees: a metre back per metre of height; (10 + 1) sqrt(2) m long.
  const HolePattern p = pattern("rows 1 holes_per_row 1 subdrill 1 hole_angle 45 face_angle 45");
  EXPECT_NEAR(p.hole_length(), 11.0 * std::numbers::sqrt2, 1e-12);
  const HoleTable holes(CsvTable::parse(hole_table_text(p), "f.csv"));
  expect_at(holes.decks()[0].hole_collar, -13, 0, 10);
  expect_at(holes.decks()[0].hole_toe, -2, 0, -1);
  // 2 m of stemming along the hole: sqrt(2) down.
  expect_at(holes.decks()[0].collar, -13 + std::numbers::sqrt2, 0, 10 - std::numbers::sqrt2);
}

TEST(HolePattern, BurdenIsTheShortestWayToTheFace) {
  const HolePattern parallel =
      pattern("rows 1 holes_per_row 1 hole_angle 60 face_angle 60 subdrill 1");
  EXPECT_NEAR(parallel.front_burden(0.0), 3.0 * std::sqrt(0.75), 1e-12);
  EXPECT_NEAR(parallel.front_burden(10.0), 3.0 * std::sqrt(0.75), 1e-12);
  // Upright holes behind a face of 45 degrees and 2 m: the way is shorter by 2 m up there.
  const HolePattern upright =
      pattern("rows 1 holes_per_row 1 face_angle 45 bench_height 2.5 stemming 1");
  EXPECT_NEAR(upright.front_burden(2.5), 0.5 * std::sqrt(0.5), 1e-12);
}

TEST(HolePattern, DelaysRunAlongEachRowFromItsFirstHole) {
  const HoleTable holes =
      table("rows 2 holes_per_row 3 delay_in_row 0.017 delay_between_rows 0.042 in_hole_delay 0.5");
  EXPECT_DOUBLE_EQ(holes.decks()[0].firing_time, 0.5);
  EXPECT_NEAR(holes.decks()[2].firing_time, 0.534, 1e-12);  // 2 x 17 ms
  EXPECT_NEAR(holes.decks()[3].firing_time, 0.542, 1e-12);
  EXPECT_NEAR(holes.decks()[5].firing_time, 0.576, 1e-12);
  EXPECT_NEAR(holes.last_firing_time(), 0.576, 1e-12);
}

TEST(HolePattern, DecksShareTheChargeFromBelow) {
  // 11 m less 2 m of stemming and 1 m between: two of 4 m.
  const HoleTable holes =
      table("rows 1 holes_per_row 1 subdrill 1 decks 2 deck_stemming 1 deck_delay 0.025");
  ASSERT_EQ(holes.decks().size(), 2u);
  EXPECT_EQ(holes.holes(), 1u);
  EXPECT_DOUBLE_EQ(holes.decks()[0].from, 7.0);
  EXPECT_DOUBLE_EQ(holes.decks()[0].to, 11.0);
  EXPECT_DOUBLE_EQ(holes.decks()[1].from, 2.0);
  EXPECT_DOUBLE_EQ(holes.decks()[1].to, 6.0);
  EXPECT_DOUBLE_EQ(holes.decks()[1].firing_time, 0.025);
}

TEST(HolePattern, AnyAnglesGiveATableThatReadsBack) {
  for (const char* angle : {"50.3", "61.7", "76", "83.1", "89.9"}) {
    const HoleTable holes = table(std::string("rows 3 holes_per_row 4 subdrill 0.7 face_angle ") +
                                  angle + " hole_angle " + angle + " spacing 3.3333333");
    EXPECT_EQ(holes.holes(), 12u) << angle;
  }
}

TEST(HolePattern, RefusesWhatLeavesNoChargeOrNoRockInFront) {
  EXPECT_EQ(fault("rows 1 holes_per_row 1 stemming 10"),
            "hole_pattern: stemming and deck_stemming must leave a charge in holes of 10 m, got "
            "'10' m and 0 times '0' m");
  EXPECT_EQ(fault("rows 1 holes_per_row 1 decks 3 deck_stemming 4"),
            "hole_pattern: stemming and deck_stemming must leave a charge in holes of 10 m, got "
            "'2' m and 2 times '4' m");
  EXPECT_EQ(fault("rows 1 holes_per_row 1 decks 2"),
            "hole_pattern: deck_stemming must be > 0 m between 2 decks, got '0'");
  // An upright hole 3 m behind the toe of a face that runs back 10 m.
  EXPECT_NE(fault("rows 1 holes_per_row 1 face_angle 45").find("behind the face, got a burden of"),
            std::string::npos);
}

TEST(HolePattern, RefusesValuesOutOfRangeByName) {
  const std::string all = "rows 1 holes_per_row 1 ";
  for (const char* word : {"subdrill -1", "face_angle 91", "face_angle 20", "hole_angle 30",
                           "stagger 1.1", "delay_in_row 17", "delay_between_rows -1", "decks 0",
                           "deck_delay 100", "in_hole_delay -0.1", "deck_stemming -1"}) {
    const std::string text = word, name = text.substr(0, text.find(' '));
    const std::string message = fault(all + text);
    EXPECT_NE(message.find("hole_pattern: " + name + " must be"), std::string::npos) << message;
  }
  EXPECT_NE(fault("rows 0 holes_per_row 1").find("rows must be"), std::string::npos);
  EXPECT_NE(fault("rows 1.5 holes_per_row 1").find("rows"), std::string::npos);
  EXPECT_NE(fault("rows 1").find("holes_per_row"), std::string::npos);
}

}  // namespace
}  // namespace muckpile
