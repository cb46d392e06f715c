// SPDX-License-Identifier: GPL-2.0-or-later
// Crushed zones by strength and of decoupled charges, by hand, alone and in a pattern.
// Scope: emulsion, P0 = 2784.375 MPa and 3300 MJ/m3, in rock of nu = 0.25: alpha = 7/3 of a shock.
// By two_stage V_k = 1.7085 V0; in 1.5625 V0 the products that keep their energy press 0.3491 P0.
#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

#include "args/input_error.h"
#include "explosive/charge_design.h"
#include "explosive/hole_loads.h"
#include "input_error_of.h"
#include "temporary_folder.h"

namespace muckpile {
namespace {

const std::string kLaws = "expansion two_stage attenuation shock ";

/// Of three hole radii unless the words say more of the zone.
ChargeDesign design(const std::string& more, const std::string& laws = kLaws) {
  const bool own = more.find("crushed_ratio") != more.npos || more.find("ucs") != more.npos;
  std::istringstream text("explosive emulsion poisson_ratio 0.25 " + laws +
                          (own ? "" : "crushed_ratio 3 ") + more);
  std::vector<std::string> words;
  for (std::string word; text >> word;) words.push_back(word);
  return charge_design(parse_args(charge_design_table(), "charge_design", words), "charge_design");
}

double radii(const std::string& more, const std::string& laws = kLaws) {
  return *design("hole_diameter 0.1 " + more, laws).crushed_radius / 0.05;
}

TEST(DesignZones, AFullHoleKeepsItsRatioToTheLastBit) {
  for (const char* words : {"", "charge_diameter 0.1", "charge_length 4", "coupling water",
                            "charge_diameter 0.1 charge_length 4 chamber_length 4"}) {
    const ChargeDesign full = design(std::string("hole_diameter 0.1 crushed_ratio 3.3 ") + words);
    EXPECT_EQ(*full.crushed_radius, 0.05 * 3.3) << words;
    EXPECT_EQ(full.full_radius, 0.05 * 3.3) << words;
  }
}

TEST(DesignZones, EndWhereTheAttenuatedPeakIsThatOfAFullHole) {
  // Isentrope in 1.5625 V0: P0/1.5625^3 = 729.9 MPa, 3300 - P0/2 (1 - 0.4096) = 2478.1 MJ/m3 are
  // left; 729.9 x 3300/2478.1 = 972.0 MPa = 0.3491 P0; 3 x 0.3491^(3/7) = 1.9109
  EXPECT_NEAR(radii("charge_diameter 0.08"), 1.9109, 2e-4);
  EXPECT_NEAR(radii("charge_diameter 0.08 coupling water"), 2.8004, 1e-4);  // 3 x 0.8^(0.72 x 3/7)
  EXPECT_NEAR(radii("charge_diameter 0.08 coupling stemming"), 2.4,
              1e-9);  // of the charge's radius
  // In 1/0.7 V0: 955.0 x 3300/2590.0 = 1216.9 MPa = 0.4370 P0; 3 x 0.4370^(3/7) = 2.1040
  EXPECT_NEAR(radii("charge_length 2.8 chamber_length 4"), 2.1040, 2e-4);
  // In 6.25 V0: 0.4 x 3300/6.25 = 211.2 MPa = 0.0759 P0; 3 x 0.0759^(3/7) = 0.994
  EXPECT_EQ(radii("charge_diameter 0.04"), 1.0);
  EXPECT_DOUBLE_EQ(radii("charge_diameter 0.08 decoupled_zone full"), 3.0);
  EXPECT_NEAR(radii("charge_diameter 0.08 coupling water", "attenuation_exponent 1.44 "),
              3.0 * 0.894427, 1e-5);  // 0.8^(0.72/1.44)
}

/// By default covolume and 1.5. P0 b = P0 V0 - 0.4 x 3300 V0: b = 0.52592 V0; products that keep
/// their energy press 0.4 x 3300/(1.5625 - b) in 1.5625 V0, 0.45734 P0; 3 x 0.45734^(2/3).
TEST(DesignZones, LawsByDefault) {
  EXPECT_NEAR(radii("charge_diameter 0.08", ""), 1.7808, 1e-4);
  EXPECT_NEAR(radii("charge_diameter 0.08 coupling water", ""), 2.6953, 1e-4);  // 0.8^(0.72/1.5)
}

/// 3.15 x 170 = 535.5 MPa: (2784.375/535.5)^(2/3) = 3.0013, in air x 0.45734^(2/3) = 1.7816; with
/// 0.8 of the density (0.8 x 5.1996)^(2/3) = 2.5865.
TEST(DesignZones, ByStrengthTheyAnswerToTheCharge) {
  EXPECT_NEAR(radii("ucs 170e6", ""), 3.0013, 1e-4);
  EXPECT_NEAR(radii("ucs 170e6 charge_diameter 0.08", ""), 1.7816, 1e-4);
  EXPECT_NEAR(radii("ucs 170e6 explosive_density 880", ""), 2.5865, 1e-4);
  EXPECT_NEAR(radii("ucs 170e6 crushing_factor 6.3", ""), 3.0013 / 1.587401, 1e-4);  // 2^(2/3)
  EXPECT_NEAR(radii("ucs 170e6 crushed_ratio 2", ""), 2.0, 1e-12);
}

TEST(DesignZones, FormulasHaveThePressureOnTheWall) {
  const std::string rock =
      "crushed_ratio auto crushed_zone esen youngs_modulus 60e9 ucs 100e6 rock_density 2700 "
      "charge_diameter 0.08 ";
  // CZI = P^3 x 1.25/(60e9 x 1e16); P = 2784.375 x 0.8^0.72 = 2371.1 MPa: 0.812 x 27.77^0.219
  EXPECT_NEAR(radii(rock + "coupling water"), 1.6814, 1e-3);
  EXPECT_EQ(radii(rock), 1.0);  // 972 MPa: CZI 1.91
}

/// What is on the wall of the zone does not depend on the decoupling: the strength that P0 and
/// crushed_ratio stand for.
TEST(DesignZones, TheLoadBeginsWithTheSamePeakOnEach) {
  const auto peak = [](const std::string& decoupling) {
    const double r1 = 0.05 * radii(decoupling);
    std::istringstream text(
        "explosive emulsion hole_diameter 0.1 poisson_ratio 0.25 vent_time 0.01 vent_decay 0.004 " +
        kLaws + decoupling);
    std::vector<std::string> words;
    for (std::string word; text >> word;) words.push_back(word);
    const BlastOptions options = blast_options(parse_args(blast_table(), "blast", words), "blast");
    const Hole zone{Vec3::Zero(), Vec3(0.0, 0.0, 4.0), r1};
    return wall_peak(options, loaded_hole(options, zone, 0), zone);
  };
  const double full = peak("");
  EXPECT_NEAR(full, 2784.375e6 / 12.9802, 1e4);  // 3^(7/3)
  for (const char* words : {"charge_diameter 0.08", "charge_diameter 0.08 coupling water",
                            "charge_diameter 0.07 coupling stemming"}) {
    EXPECT_NEAR(peak(words), full, 1e-12 * full) << words;
  }
}

const std::string kColumns =
    "hole,collar_x_m,collar_y_m,collar_z_m,toe_x_m,toe_y_m,toe_z_m,diameter_m,charge_diameter_m,"
    "charge_length_m";

TEST(DesignZones, GoIntoThePatternsTable) {
  const testing::TemporaryFolder folder;
  const std::string file =
      testing::write_text(folder.path() / "holes.csv",
                          "# mine\n" + kColumns + ",crushed_radius_m\n" +
                              "a,-3,0,4,-3,0,0,0.1,,,\nb,-3,4,4,-3,4,0,0.1,0.08,,\n" +
                              "c,-3,8,4,-3,8,0,0.1,,2.8,\nd,-3,12,4,-3,12,0,0.1,0.08,,0.2\n");
  const ChargeDesign plan = design("hole_table " + file);
  EXPECT_EQ(plan.crushed_table.rfind("# mine\n", 0), 0U) << plan.crushed_table;
  const std::vector<Hole> zones =
      HoleTable(CsvTable::parse(plan.crushed_table, "table")).crushed_zones(1.0);
  ASSERT_EQ(zones.size(), 4U);  // every row has its radius
  EXPECT_EQ(zones[0].radius, 0.05 * 3.0);
  EXPECT_EQ(zones[1].radius, *design("hole_diameter 0.1 charge_diameter 0.08").crushed_radius);
  EXPECT_NEAR(zones[2].radius, 0.05 * 2.1040, 1e-5);
  EXPECT_EQ(zones[3].radius, 0.2);
  EXPECT_EQ(plan.pattern_crushed_radius, zones[1].radius);
  EXPECT_EQ(plan.pattern_full_radius, 0.05 * 3.0);
  EXPECT_EQ(design("decoupled_zone full hole_table " + file).pattern_crushed_radius, 0.05 * 3.0);
}

TEST(DesignZones, ByStrengthEachDeckHasThatOfItsExplosive) {
  const testing::TemporaryFolder folder;
  const std::string file = testing::write_text(
      folder.path() / "holes.csv",
      kColumns + ",explosive\na,-3,0,4,-3,0,0,0.1,,,anfo\nb,-3,4,4,-3,4,0,0.2,,,\n");
  const ChargeDesign plan = design("ucs 170e6 hole_table " + file, "");
  const std::vector<Hole> zones =
      HoleTable(CsvTable::parse(plan.crushed_table, "table")).crushed_zones(1.0);
  EXPECT_NEAR(zones[0].radius, 0.05 * 2.0746, 1e-5);  // (1600/535.5)^(2/3)
  EXPECT_NEAR(zones[1].radius, 0.10 * 3.0013, 1e-5);
}

TEST(DesignZones, CountTheStylesWordsWhereARowHasNone) {
  const testing::TemporaryFolder folder;
  const std::string text = kColumns + "\na, -3,0,4,-3,0,0,0.1,,\n";
  const std::string file = testing::write_text(folder.path() / "holes.csv", text);
  const ChargeDesign thin = design("charge_diameter 0.08 coupling water hole_table " + file);
  EXPECT_NEAR(thin.pattern_crushed_radius, 0.05 * 2.8004, 1e-5);
  EXPECT_NEAR(thin.pattern_mass, 1100.0 * 3.14159265 * 0.0016 * 4.0, 1e-6);
}

TEST(DesignZones, RefuseChargesThatDoNotFit) {
  EXPECT_EQ(input_error_of([] { (void)design("hole_diameter 0.1 charge_diameter 0.12"); }),
            "charge_design: charge_diameter must be at most hole_diameter m, got '0.12'");
  EXPECT_EQ(input_error_of([] {
              (void)design(
                  "hole_diameter 0.1 crushed_zone strength ucs 1e8 "
                  "crushed_ratio 2");
            }),
            "charge_design: crushed_ratio is for crushed_zone multiple, got crushed_zone strength");
  EXPECT_EQ(input_error_of([] { (void)design("hole_diameter 0.1 crushed_ratio auto"); }),
            "charge_design: crushed_zone strength needs ucs [Pa] of the rock; or give "
            "crushed_zone multiple");
  EXPECT_EQ(input_error_of([] {
              (void)design(
                  "hole_diameter 0.1 crushed_ratio 2 "
                  "crushing_factor 3");
            }),
            "charge_design: crushing_factor is for crushed_zone strength, got crushed_zone "
            "multiple");
  EXPECT_EQ(input_error_of([] { (void)design("hole_diameter 0.1 ucs 1e5", ""); }),
            "charge_design: crushed_zone strength makes a zone of 427.509 hole radii, at most 20 "
            "are allowed: ucs, crushing_factor or attenuation_exponent is too small, or give "
            "crushed_zone multiple");
  EXPECT_EQ(input_error_of([] { (void)design("crushed_table a.csv"); }),
            "charge_design: crushed_table needs hole_table");
  const testing::TemporaryFolder folder;
  const std::string file =
      testing::write_text(folder.path() / "holes.csv", kColumns + "\nb7,0,0,4,0,0,0,0.1,0.2,\n");
  EXPECT_EQ(input_error_of([&] { (void)design("hole_table " + file); }),
            "charge_design: hole 'b7' of hole_table: charge_diameter must be at most "
            "hole_diameter m, got '0.2'");
}

}  // namespace
}  // namespace muckpile
