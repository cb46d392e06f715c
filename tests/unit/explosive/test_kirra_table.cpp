// SPDX-License-Identifier: GPL-2.0-or-later
// Holes of Kirra: columns, units, tie-up, and the way from the mine's coordinates to the bench's.
// Scope: made from the columns of Kirra's writer; the coordinates are those of a map grid.
#include <gtest/gtest.h>

#include "explosive/hole_table.h"
#include "explosive/kirra_table.h"
#include "input_error_of.h"

namespace muckpile {
namespace {

// Two holes 5 m apart along north, 11.5 m deep, 165 mm; the second fires 42 ms after the first.
const std::string kFourteen =
    "NORTH,hole,1,478327.7000,6772294.1000,210.0000,478327.7000,6772294.1000,198.5000,165.0000,"
    "Production,NORTH:::1,0,#FFFFFF\n"
    "NORTH,hole,2,478327.7000,6772299.1000,210.0000,478327.7000,6772299.1000,198.5000,165.0000,"
    "Production,NORTH:::1,42,#FFFFFF\n";

const std::string kNamed =
    "entityName,entityType,holeID,startXLocation,startYLocation,startZLocation,endXLocation,"
    "endYLocation,endZLocation,gradeXLocation,gradeYLocation,gradeZLocation,subdrillAmount,"
    "subdrillLength,benchHeight,holeDiameter,holeType,fromHoleID,timingDelayMilliseconds,"
    "colorHexDecimal\n"
    "A,hole,1,100,200,60,102,200,48,101.75,200,49.5,1.5,1.52,10.5,102,Production,A:::1,0,red\n"
    "B,hole,1,100,204,60,102,204,48,101.75,204,49.5,1.5,1.52,10.5,102,Production,A:::1,25,red\n";

KirraFrame frame(double bearing_deg = 90.0) { return {bearing_deg * M_PI / 180.0, {}, 4.0, 1.5}; }

HoleTable converted(const std::string& text, const KirraFrame& in) {
  return HoleTable(CsvTable::parse(convert_kirra(text, "plan.csv", in, {3.0, 0.5}).table, "table"));
}

TEST(KirraTable, FourteenColumnsBecomeAHoleTable) {
  const HoleTable table = converted(kFourteen, frame());
  ASSERT_EQ(table.decks().size(), 2u);
  const Deck &first = table.decks()[0], &second = table.decks()[1];
  EXPECT_EQ(second.hole, "2");
  EXPECT_NEAR(first.diameter, 0.165, 1e-12);
  EXPECT_NEAR(first.from, 3.0, 1e-12);
  EXPECT_NEAR(first.to, 11.5, 1e-9);
  EXPECT_NEAR(first.firing_time, 0.5, 1e-12);
  EXPECT_NEAR(second.firing_time, 0.542, 1e-12);
  // 4 m behind the toe, about y = 0, the floor 1.5 m above the lower ends
  EXPECT_NEAR((first.hole_collar - Vec3(-4.0, -2.5, 10.0)).norm(), 0.0, 1e-6);
  EXPECT_NEAR((second.hole_toe - Vec3(-4.0, 2.5, -1.5)).norm(), 0.0, 1e-6);
}

TEST(KirraTable, TheThrowsBearingBecomesX) {
  // the face looks to the north: x is north, y is west, and hole 2 stands in front of hole 1
  const HoleTable table = converted(kFourteen, frame(0.0));
  EXPECT_NEAR((table.decks()[0].hole_collar - Vec3(-9.0, 0.0, 10.0)).norm(), 0.0, 1e-6);
  EXPECT_NEAR((table.decks()[1].hole_collar - Vec3(-4.0, 0.0, 10.0)).norm(), 0.0, 1e-6);
}

TEST(KirraTable, AnOriginIsTakenAsItIsAndGivenBack) {
  KirraFrame in = frame(0.0);
  in.origin = Vec3(478330.0, 6772300.0, 200.0);
  const ConvertedHoles holes = convert_kirra(kFourteen, "plan.csv", in, {3.0, 0.0});
  EXPECT_NEAR((holes.origin - *in.origin).norm(), 0.0, 1e-6);
  EXPECT_NEAR(holes.collar_height, 10.0, 1e-9);
  const HoleTable table(CsvTable::parse(holes.table, "table"));
  // 5.9 m south and 2.3 m west of it
  EXPECT_NEAR((table.decks()[0].hole_collar - Vec3(-5.9, 2.3, 10.0)).norm(), 0.0, 1e-6);
}

TEST(KirraTable, AnOriginFarFromAllHolesIsRefused) {
  KirraFrame in = frame();
  in.origin = Vec3(478330.0, 6773400.0, 200.0);
  EXPECT_EQ(input_error_of([&] {
              (void)convert_kirra(kFourteen, "plan.csv", in, {3.0, 0.0});
            }),
            "plan.csv: origin must be within 1000 m of a hole, got '478330 6773400 200'; the "
            "middle of the collars is at 478327.7 6772296.6 210");
}

TEST(KirraTable, NamedColumnsGiveTheSubdrillAndHolesOfSeveralBlasts) {
  const HoleTable table = converted(kNamed, frame());
  ASSERT_EQ(table.holes(), 2u);
  EXPECT_EQ(table.decks()[1].hole, "B.1");
  EXPECT_NEAR(table.decks()[1].firing_time, 0.525, 1e-12);
  EXPECT_NEAR(table.decks()[0].hole_toe.z(), -1.5, 1e-9);
  // x at the floor, an eighth of the way up from the toe at 102 to the collar at 100: 101.75
  EXPECT_NEAR(table.decks()[0].hole_toe.x(), -4.0 + 0.25, 1e-9);
}

TEST(KirraTable, ASubdrillThatIsEmptyIsThatOfTheFrame) {
  std::string text = kNamed;
  for (std::size_t at; (at = text.find(",1.5,1.52")) != std::string::npos;)
    text.replace(at, 9, ",,1.52");
  KirraFrame in = frame();
  in.subdrill = 2.0;
  const ConvertedHoles holes = convert_kirra(text, "plan.csv", in, {3.0, 0.0});
  EXPECT_NEAR(holes.origin.z(), 48.0 + 2.0, 1e-9);
  EXPECT_NEAR(holes.collar_height, 60.0 - 50.0, 1e-9);
}

TEST(KirraTable, TwelveColumnsHaveNoBlast) {
  const HoleTable table = converted(
      "7,0,0,10,0,0,-1,89,Production,X:::7,0,red\n8,0,3,10,0,3,-1,89,Production,7,17,red\r\n",
      frame());
  EXPECT_NEAR(table.decks()[1].firing_time, 0.517, 1e-12);
  EXPECT_NEAR(table.decks()[1].diameter, 0.089, 1e-12);
}

TEST(KirraTable, RefusesWithFileAndLine) {
  const auto refused = [](const std::string& text) {
    return input_error_of([&] { (void)convert_kirra(text, "plan.csv", frame(), {3.0, 0.0}); });
  };
  EXPECT_EQ(
      refused("1,0,0,0,0\n"),
      "plan.csv:1: must have 12 or 14 columns, or a first line that names them as Kirra does, "
      "got '5' columns");
  EXPECT_EQ(refused(kFourteen + "NORTH,hole,3\n"), "plan.csv:3: expected 14 fields, got 3");
  EXPECT_EQ(refused("1,0,0,10,0,0,-1,0.089,P,1,0,red\n"),
            "plan.csv:1: holeDiameter must be >= 5 and <= 1000 mm, got '0.089'");
  EXPECT_EQ(refused("1,0,a,10,0,0,-1,89,P,1,0,red\n"),
            "plan.csv:1: startYLocation must be a number in m, got 'a'");
  EXPECT_EQ(refused("1,0,0,10,0,0,8,89,P,1,0,red\n"),
            "plan.csv:1: hole '1' must be longer than 3 m, its stemming, got '2'");
  EXPECT_EQ(refused("1,0,0,10,0,0,-1,89,P,5,0,red\n"),
            "plan.csv:1: fromHoleID must be a hole of the file, got '5'");
  EXPECT_EQ(refused(kFourteen + kFourteen), "plan.csv:3: hole '1' is there twice");
  EXPECT_EQ(refused("1,0,0,10,0,0,-1,89,P,1,0,red\n#2,0,3,10,0,3,-1,89,P,1,17,red\n"),
            "plan.csv:2: holeID must not begin with '#', got '#2'");
  EXPECT_EQ(refused("#A" + kFourteen),
            "plan.csv:1: entityName must not begin with '#', got '#ANORTH'");
  EXPECT_EQ(refused("A,hole,#1,0,0,10,0,0,-1,89,P,#1,0,red\n"),
            "plan.csv:1: holeID must not begin with '#', got '#1'");
  EXPECT_EQ(refused("entityName,holeID,startXLocation\nA,1,2\n"),
            "plan.csv: has no column 'startYLocation'");
}

}  // namespace
}  // namespace muckpile
