// SPDX-License-Identifier: GPL-2.0-or-later
// Charges laid into the holes of a plan, and tables in mine coordinates.
// Scope: core only.
#include <gtest/gtest.h>

#include "explosive/charge_plan.h"
#include "explosive/hole_table.h"
#include "input_error_of.h"

namespace muckpile {
namespace {

// Two holes, the first of two decks.
const std::string kPlan =
    "# a plan\n"
    "hole,collar_x_m,collar_y_m,collar_z_m,toe_x_m,toe_y_m,toe_z_m,diameter_m,from_m,to_m,after,"
    "surface_delay_s,in_hole_delay_s\n"
    "a,-3,0,10,-3,0,0,0.1,6,10,,0,0.5\n"
    "a,-3,0,10,-3,0,0,0.1,2,5,,0,0.525\n"
    "b,-3,4,10,-3,4,0,0.1,2,10,a,0.017,0.5\n";

HoleTable charged(const std::string& charges) {
  return HoleTable(
      CsvTable::parse(with_charges(kPlan, "plan", CsvTable::parse(charges, "c.csv")), "made"));
}

TEST(ChargePlan, ARowReplacesTheDecksOfItsHole) {
  const HoleTable table = charged(
      "hole,explosive,explosive_density_kg_m3,vod_m_s,coupling,charge_diameter_m,from_m,to_m\n"
      "a,emulsion,1150,4800,water,0.08,3,10\n");
  ASSERT_EQ(table.decks().size(), 2u);
  const Deck &a = table.decks()[0], &b = table.decks()[1];
  EXPECT_EQ(*a.explosive, "emulsion");
  EXPECT_EQ(*a.explosive_density, 1150.0);
  EXPECT_EQ(*a.detonation_velocity, 4800.0);
  EXPECT_EQ(*a.coupling, Coupling::water);
  EXPECT_EQ(a.from, 3.0);
  EXPECT_EQ(a.firing_time, 0.5);  // of the first deck
  EXPECT_FALSE(b.explosive || b.explosive_density || b.detonation_velocity || b.coupling);
  EXPECT_DOUBLE_EQ(b.firing_time, 0.517);
}

TEST(ChargePlan, ColumnsMeetWhateverTheirLetters) {
  std::string plan = kPlan;
  plan.replace(plan.find("from_m"), 6, "From_M");
  plan.replace(plan.find("collar_x_m"), 10, "Collar_X_m");
  const CsvTable charges = CsvTable::parse("HOLE,FROM_m,to_m,Explosive\nb,4,9,tnt\n", "c.csv");
  const CsvTable made = CsvTable::parse(with_charges(plan, "plan", charges), "made");
  EXPECT_EQ(made.header().size(), 14u);  // 13 and explosive
  const HoleTable table(made);
  EXPECT_EQ(table.decks()[2].from, 4.0);
  EXPECT_EQ(*table.decks()[2].explosive, "tnt");
  const HoleTable placed(CsvTable::parse(
      placed_table(CsvTable::parse(plan, "plan"), "plan", {Vec3(-5, 0, 0), M_PI / 2}), "placed"));
  EXPECT_EQ(placed.decks()[0].hole_collar, Vec3(2, 0, 10));
}

TEST(ChargePlan, SeveralRowsAreDecks) {
  const HoleTable table = charged("hole,from_m,to_m,in_hole_delay_s\nb,7,10,0.5\nb,2,6,0.525\n");
  ASSERT_EQ(table.decks().size(), 4u);
  EXPECT_EQ(table.decks()[3].to, 6.0);
  EXPECT_DOUBLE_EQ(table.decks()[3].firing_time, 0.542);
}

TEST(ChargePlan, FaultsNameTheLine) {
  EXPECT_EQ(input_error_of([] { (void)charged("hole,vod_m_s\na1,4000\n"); }),
            "c.csv:2: hole must be one of the plan, got 'a1'");
  EXPECT_NE(input_error_of([] {
              (void)charged("hole,toe_x_m\na,1\n");
            }).find("c.csv: unknown column 'toe_x_m'"),
            std::string::npos);
  EXPECT_NE(input_error_of([] {
              (void)charged("hole,coupling\nb,mud\n");
            }).find("c.csv:2: coupling must be one of air, water, stemming, got 'mud'"),
            std::string::npos);
  // of the second deck of a hole
  EXPECT_EQ(input_error_of([] {
              (void)charged("hole,from_m,to_m,vod_m_s\nb,7,10,\nb,2,6,9e9\n");
            }).find("c.csv:3: vod_m_s must be"),
            0u);
}

TEST(ChargePlan, ARowForAHoleOfSeveralDecksHasDepths) {
  EXPECT_EQ(input_error_of([] { (void)charged("hole,from_m\na,3\n"); }),
            "c.csv:2: to_m must be given: hole 'a' has 2 decks in the plan");
}

TEST(ChargePlan, AnOriginFarFromAllHolesIsRefused) {
  const std::string fault = input_error_of([] {
    (void)placed_table(CsvTable::parse(kPlan, "plan"), "plan", {{5e5, 7e6, 0.0}, 0.0});
  });
  EXPECT_NE(fault.find("plan: origin must be within 1000 m of a hole"), std::string::npos) << fault;
}

TEST(ChargePlan, ATableOfTheMineIsTurnedIntoTheRun) {
  // the face looks to the north: x is north, y is west
  const std::string text =
      placed_table(CsvTable::parse(kPlan, "plan"), "plan", {{-1.0, 2.0, 5.0}, 0.0});
  const HoleTable table(CsvTable::parse(text, "made"));
  EXPECT_LT((table.decks()[2].hole_collar - Vec3(2.0, 2.0, 5.0)).norm(), 1e-9);
  EXPECT_LT((table.decks()[0].hole_toe - Vec3(-2.0, 2.0, -5.0)).norm(), 1e-9);
  EXPECT_EQ(table.decks()[1].firing_time, 0.525);
}

}  // namespace
}  // namespace muckpile
