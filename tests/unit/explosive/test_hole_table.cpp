// SPDX-License-Identifier: GPL-2.0-or-later
// Blast patterns: geometry of decks, surface and in-hole delays, and every fault of a row.
// Scope: core only.
#include <gtest/gtest.h>

#include "explosive/hole_table.h"
#include "input_error_of.h"

namespace muckpile {
namespace {

const std::string kKnown =
    " (known: hole, collar_x_m, collar_y_m, collar_z_m, toe_x_m, toe_y_m, toe_z_m, "
    "diameter_m, from_m, to_m, explosive, after, primer, charge_diameter_m, "
    "charge_length_m, surface_delay_s, in_hole_delay_s, crushed_radius_m, "
    "explosive_density_kg_m3, vod_m_s, coupling, scatter_s)";

const std::string kHead =
    "hole,collar_x_m,collar_y_m,collar_z_m,toe_x_m,toe_y_m,toe_z_m,diameter_m";

HoleTable read(const std::string& more_columns, const std::string& rows) {
  return HoleTable(CsvTable::parse(kHead + more_columns + "\n" + rows, "p.csv"));
}

std::string fault(const std::string& more_columns, const std::string& rows) {
  return input_error_of([&] { (void)read(more_columns, rows); });
}

TEST(HoleTable, AChamberIsPlacedAlongTheHole) {
  // 5 m long, 3 down for 4 across; 1 m of stemming
  const HoleTable table = read(",from_m,to_m", "a, 0,0,10, 4,0,7, 0.1, 1,5\n");
  const Deck& deck = table.decks()[0];
  EXPECT_LT((deck.collar - Vec3(0.8, 0, 9.4)).norm(), 1e-12);
  EXPECT_LT((deck.toe - Vec3(4, 0, 7)).norm(), 1e-12);
  const Hole zone = table.crushed_zones(3.0)[0];
  EXPECT_NEAR(zone.radius, 0.15, 1e-15);
}

TEST(HoleTable, SemicolonsAreNoCommas) {
  EXPECT_EQ(input_error_of([] { (void)CsvTable::parse("hole;diameter_m\na;0,1\n", "p.csv"); }),
            "p.csv: fields must stand between commas, got 'hole;diameter_m'");
}

TEST(HoleTable, CapitalLettersInTheHeaderDoNotCount) {
  const std::string rows = "a,1,2,10,1,2,0,0.1,emulsion\n";
  const HoleTable table(CsvTable::parse(
      "Hole,Collar_X_m,COLLAR_Y_M,Collar_Z_m,Toe_x_m,Toe_y_m,Toe_z_m,Diameter_m,Explosive\n" + rows,
      "p.csv"));
  ASSERT_EQ(table.decks().size(), 1u);
  EXPECT_EQ(table.decks()[0].hole_collar, Vec3(1, 2, 10));
  EXPECT_EQ(*table.decks()[0].explosive, "emulsion");
  EXPECT_EQ(fault(",Toe_x_m", "a,0,0,10,0,0,0,0.1,1\n"),
            "p.csv: column 'toe_x_m' is there twice, once as 'Toe_x_m'");
  EXPECT_EQ(fault(",Explosve", "a,0,0,10,0,0,0,0.1,anfo\n"),
            "p.csv: unknown column 'Explosve'; did you mean 'explosive'?" + kKnown);
}

TEST(HoleTable, WithoutDepthsTheWholeHoleIsCharged) {
  const HoleTable table = read("", "a,0,0,10,0,0,0,0.1\n");
  EXPECT_EQ(table.decks()[0].from, 0.0);
  EXPECT_EQ(table.decks()[0].to, 10.0);
  EXPECT_FALSE(table.decks()[0].explosive.has_value());
}

TEST(HoleTable, SurfaceDelaysFollowTheTieUpWhateverTheOrderOfRows) {
  const HoleTable table = read(",after,surface_delay_s,in_hole_delay_s",
                               "c,0,0,1,0,0,0,0.1,b,0.025,0.475\n"
                               "a,1,0,1,1,0,0,0.1,,0.000017,0.475\n"
                               "b,2,0,1,2,0,0,0.1,a,0.042,0.475\n");
  EXPECT_DOUBLE_EQ(table.decks()[0].firing_time, 0.542017);  // 17 us + 42 + 25 + 475 ms
  EXPECT_DOUBLE_EQ(table.decks()[1].firing_time, 0.475017);
  EXPECT_DOUBLE_EQ(table.decks()[2].firing_time, 0.517017);
}

TEST(HoleTable, ScatterMovesTheFiringTimeButNotBeforeTheStart) {
  const HoleTable table = read(",surface_delay_s,in_hole_delay_s,scatter_s",
                               "a,0,0,1,0,0,0,0.1,0.017,0.475,-0.006\n"
                               "b,2,0,1,2,0,0,0.1,0.002,,-0.005\n");
  EXPECT_DOUBLE_EQ(table.decks()[0].firing_time, 0.486);
  EXPECT_EQ(table.decks()[1].firing_time, 0.0);
}

TEST(HoleTable, RowsOfOneHoleAreItsDecks) {
  const HoleTable table = read(",from_m,to_m,explosive,in_hole_delay_s,crushed_radius_m",
                               "a,0,0,10,0,0,0,0.1,3,6,anfo,0.025,\n"
                               "a,0,0,10,0,0,0,0.1,7,10,emulsion,0,0.2\n");
  EXPECT_EQ(table.holes(), 1u);
  ASSERT_EQ(table.decks().size(), 2u);
  EXPECT_EQ(*table.decks()[1].explosive, "emulsion");
  EXPECT_EQ(table.decks()[0].firing_time, 0.025);
  EXPECT_EQ(table.crushed_zones(3.0)[1].radius, 0.2);
}

TEST(HoleTable, ASpreadsheetsByteOrderMarkIsSkipped) {
  const CsvTable csv = CsvTable::parse("\xEF\xBB\xBFhole,x\na,1\n", "p.csv");
  EXPECT_EQ(csv.column("hole"), 0u);
}

TEST(HoleTable, ASpreadsheetMayPutFieldsInQuotes) {
  const CsvTable csv = CsvTable::parse("\"hole\",x ,y\n\"a of row 1\" , \" 1\",\"\"\n", "p.csv");
  EXPECT_EQ(csv.column("hole"), 0u);
  EXPECT_EQ(csv.word(0, 0), "a of row 1");
  EXPECT_EQ(csv.word(0, 1), "1");
  EXPECT_EQ(csv.word(0, 2), "");
  const HoleTable table = read("", "\"a\",\"0\",0,10,0,0,0,\"0.1\"\n");
  EXPECT_EQ(table.decks()[0].hole, "a");
  for (const std::string field : {"\"a, b\"", "\"", "\"a\"b", "\"a\"\"b\"", "\"#1\""}) {
    const std::string shown = field.substr(0, field.find(','));
    EXPECT_EQ(
        input_error_of([&] { (void)CsvTable::parse("hole,x\n" + field + ",1\n", "p.csv"); }),
        "p.csv:2: a field in quotes must hold no comma or quote, nor begin a line with #, got " +
            shown);
  }
}

TEST(HoleTable, WhatSpreadsheetsAddIsSkipped) {
  const CsvTable csv = CsvTable::parse("sep=,\nhole,colour\na,\"#FF0000\"\n,\n , \nb,\n", "p.csv");
  ASSERT_EQ(csv.rows(), 2u);
  EXPECT_EQ(csv.word(0, 1), "#FF0000");
  EXPECT_EQ(csv.word(1, 0), "b");
  EXPECT_EQ(input_error_of([] { (void)CsvTable::parse("Plan 7,,\nhole,x,y\n", "p.csv"); }),
            "p.csv: the first line must name every column");
}

TEST(HoleTable, AnOldSpreadsheetEndsLinesWithCarriageReturns) {
  const CsvTable csv = CsvTable::parse("hole,x\ra,1\rb,2\r", "p.csv");
  ASSERT_EQ(csv.rows(), 2u);
  EXPECT_EQ(csv.word(1, 0), "b");
}

TEST(HoleTable, OtherTextThanUtf8WithCommasIsNamed) {
  const std::string wide("\xFF\xFEh\0o\0", 6);
  EXPECT_EQ(input_error_of([&] { (void)CsvTable::parse(wide, "p.csv"); }),
            "p.csv: must be in UTF-8, got UTF-16");
  EXPECT_EQ(CsvTable::parse("hole\n\xC3\x84"
                            "1\n",
                            "p.csv")
                .word(0, 0),
            "\xC3\x84"
            "1");
  for (const std::string bad : {"\xC4"
                                "1",
                                "\xE2\x82", "\x80", "\xC0\xAF", "\xFF"}) {
    EXPECT_EQ(input_error_of([&] { (void)CsvTable::parse("hole\na\n" + bad + "\n", "p.csv"); }),
              "p.csv:3: must be in UTF-8, got a byte that is not; save it as CSV in UTF-8");
  }
  EXPECT_EQ(input_error_of([] { (void)CsvTable::parse("hole\tx\na\t1\n", "p.csv"); }),
            "p.csv: fields must stand between commas, got 'hole\tx'");
}

TEST(HoleTable, EachFaultIsNamedWithItsLine) {
  const std::string hole = "a,0,0,10,0,0,0,0.1";
  EXPECT_EQ(fault(",dely", hole + ",1\n"), "p.csv: unknown column 'dely'" + kKnown);
  EXPECT_EQ(fault("", "a,0,0,10,0,0,0,0\n"),
            "p.csv:2: diameter_m must be >= 0.001 and <= 2, got '0'");
  EXPECT_EQ(fault(",toe_x_m", hole + ",1\n"), "p.csv: column 'toe_x_m' is there twice");
  EXPECT_EQ(fault("", "a,0,0,10,0,0,,0.1\n"), "p.csv:2: toe_z_m is missing");
  EXPECT_EQ(fault("", "a,0,0,0,0,0,0,0.1\n"), "p.csv:2: collar and toe are the same point");
  EXPECT_EQ(fault("", ",0,0,10,0,0,0,0.1\n"), "p.csv:2: hole is missing");
  EXPECT_EQ(fault(",to_m", hole + ",11\n"),
            "p.csv:2: to_m must be <= 10 m, the length of the hole, got '11'");
  EXPECT_EQ(fault(",from_m,to_m", hole + ",5,4\n"), "p.csv:2: to_m must be > from_m, got '4'");
  EXPECT_EQ(fault(",from_m,to_m", hole + ",3,7\n" + hole + ",6,9\n"),
            "p.csv:3: the deck overlaps another one of hole 'a'");
  EXPECT_EQ(fault("", hole + "\na,0,0,10,0,0,0,0.2\n"),
            "p.csv:3: hole 'a' must have the collar, toe and diameter of its first row");
  EXPECT_EQ(fault(",after,surface_delay_s", hole + ",b,0.1\n"),
            "p.csv:2: after names no hole of the table, got 'b'");
  EXPECT_EQ(fault(",after,surface_delay_s", hole + ",b,0.1\nb,1,0,10,1,0,0,0.1,a,0.1\n"),
            "p.csv:2: the surface delays of hole 'a' lead back to itself");
  EXPECT_EQ(fault(",surface_delay_s", hole + ",-1\n"),
            "p.csv:2: surface_delay_s must be >= 0 and <= 60, got '-1'");
  EXPECT_EQ(fault(",from_m,to_m,surface_delay_s", hole + ",1,2,0.1\n" + hole + ",3,4,0.2\n"),
            "p.csv:3: hole 'a' must have the surface delay of its first row");
  EXPECT_EQ(fault("", ""), "p.csv: has no row");
  EXPECT_EQ(fault(",coupling", hole + ",mud\n"),
            "p.csv:2: coupling must be one of air, water, stemming, got 'mud'");
  EXPECT_EQ(fault(",explosive_density_kg_m3", hole + ",1.15\n"),
            "p.csv:2: explosive_density_kg_m3 must be >= 10 and <= 10000, got '1.15'");
  EXPECT_EQ(fault(",vod_m_s", hole + ",4.8\n"),
            "p.csv:2: vod_m_s must be >= 100 and <= 1e+05, got '4.8'");
  EXPECT_EQ(fault(",scatter_s", hole + ",12\n"),
            "p.csv:2: scatter_s must be >= -10 and <= 10, got '12'");
}

}  // namespace
}  // namespace muckpile
