// SPDX-License-Identifier: GPL-2.0-or-later
// Sub-command flyrock: formulas against worked numbers, and what it finds of a bench.
// Scope: measure/blast_formulas, report/flyrock_holes and report_flyrock on the made-up bench.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "args/csv_table.h"
#include "input_error_of.h"
#include "measure/blast_formulas.h"
#include "report/all_reports.h"
#include "report/flyrock_holes.h"
#include "report/not_measurable.h"
#include "report/notes.h"
#include "report/reports.h"
#include "synthetic_run.h"

namespace muckpile {
namespace {

using namespace testing;

// A worked blast of the authors: 229 mm, 1.15 t/m3, so 47.365 kg/m; stemming 3.8 m, burden 4.5 m,
// k = 28: face burst 241.2 m, cratering 374.4 m.
constexpr double kPerMetre = 47.365, kStemming = 3.8, kDiameter = 0.229;

TEST(FlyrockFormulas, AreThoseOfRichardsAndMoore) {
  EXPECT_NEAR(0.25 * std::numbers::pi * kDiameter * kDiameter * 1150.0, kPerMetre, 1e-3);
  EXPECT_NEAR(richards_moore_range(28.0, kPerMetre, 4.5), 241.2, 0.05);
  EXPECT_NEAR(richards_moore_range(28.0, kPerMetre, kStemming), 374.4, 0.05);
  // sqrt(16)/4 = 1: k^2/g = 400/9.81. Half the stemming: 2^2.6 = 6.06287 times as far.
  EXPECT_NEAR(richards_moore_range(20.0, 16.0, 4.0), 40.7747, 1e-4);
  EXPECT_NEAR(richards_moore_range(20.0, 16.0, 2.0), 40.7747 * 6.06287, 1e-2);
}

TEST(FlyrockFormulas, GunBarrellingIsCrateringTimesTheSineOfTwiceTheAngle) {
  // sin 160 degrees = 0.342020.
  const double angle = 80.0 * std::numbers::pi / 180.0;
  EXPECT_NEAR(gun_barrelling_range(28.0, kPerMetre, kStemming, angle), 374.4 * 0.342020, 0.02);
  EXPECT_NEAR(gun_barrelling_range(28.0, kPerMetre, kStemming, 0.5 * std::numbers::pi), 0.0, 1e-9);
}

TEST(FlyrockFormulas, AreThoseOfMcKenzie) {
  // The same blast, whose scaled depth of burial is 1.037: ten diameters are 2.29 m and 108.466 kg;
  // (3.8 + 1.145)/108.466^(1/3) = 4.945/4.76896. 1.0369^-2.167 = 0.92449, 229^(2/3) = 37.4310.
  const double depth = scaled_depth_of_burial(kStemming, 9.7, kDiameter, kPerMetre);
  EXPECT_NEAR(depth, 1.0369, 1e-4);
  EXPECT_NEAR(mckenzie_range(depth, kDiameter), 9.74 * 0.92449 * 37.4310, 0.05);
  EXPECT_NEAR(mckenzie_fragment(depth, kDiameter, 2600.0), 3e-3 * 0.92449 * 37.4310, 1e-4);
  EXPECT_NEAR(mckenzie_fragment(depth, kDiameter, 5200.0), 1.5e-3 * 0.92449 * 37.4310, 1e-4);
}

TEST(FlyrockFormulas, OfANarrowHoleCountEightDiametersAndOfAShortChargeAllOfIt) {
  // 0.05 m: 0.4 m at 20 kg/m are 8 kg: (1.8 + 0.2)/2.
  EXPECT_NEAR(scaled_depth_of_burial(1.8, 5.0, 0.05, 20.0), 1.0, 1e-12);
  // 0.1 m at 80 kg/m are 8 kg: (1.95 + 0.05)/2.
  EXPECT_NEAR(scaled_depth_of_burial(1.95, 0.1, 0.05, 80.0), 1.0, 1e-12);
}

class Flyrock : public ::testing::Test {
 protected:
  void SetUp() override {
    write_bench(temporary_.path());
    add_to_scene("\"charge_mass_kg\": 64.0, ");
  }
  void add_to_scene(const std::string& words) const {
    const auto scene = temporary_.path() / "dump/scene.json";
    std::string text = text_of(scene);
    write_text(scene, text.insert(1, words));
  }
  [[nodiscard]] ResultFolder folder() const { return ResultFolder(temporary_.path()); }
  [[nodiscard]] nlohmann::ordered_json summary() const {
    return read_json_object(folder().file("summary.json"));
  }
  TemporaryFolder temporary_;
};

// 64 kg in 9 m, burden 5 m, stemming 2.5 m.
TEST_F(Flyrock, OfABenchHasBothEndsOfTheConstant) {
  report_flyrock(folder());
  const auto keys = summary();
  const double per_metre = 64.0 / 9.0;
  EXPECT_NEAR(keys["formula_face_burst_low_m"],
              14.0 * 14.0 / 9.81 * std::pow(std::sqrt(per_metre) / 5.0, 2.6), 1e-6);
  EXPECT_NEAR(keys["formula_cratering_high_m"],
              900.0 / 9.81 * std::pow(std::sqrt(per_metre) / 2.5, 2.6), 1e-6);
  const double mckenzie = mckenzie_range(scaled_depth_of_burial(2.5, 9.0, 0.1, per_metre), 0.1);
  EXPECT_NEAR(keys["formula_mckenzie_m"], mckenzie, 1e-6);
  EXPECT_NEAR(keys["formula_clearance_m"],
              2.0 * std::max(mckenzie, keys["formula_cratering_high_m"].get<double>()), 1e-6);
  EXPECT_TRUE(keys["formula_mckenzie_fragment_m"].is_null());  // the rock's density is not known
  // From the back of the prism, x = -4.75, none farther than to the last step of the pile.
  EXPECT_GT(keys["farthest_block_m"], 13.0);
  EXPECT_LT(keys["farthest_block_m"], 18.5);
  const CsvTable table = CsvTable::read(folder().file("flyrock.csv"));
  ASSERT_EQ(table.rows(), 1U);
  EXPECT_NEAR(table.number(0, table.column("charge_kg_m")), per_metre, 1e-4);
}

TEST_F(Flyrock, TakesTheConstantOfTheSiteAndAFactor) {
  report_flyrock(folder(), {20.0, 80.0, 3.0});
  const auto keys = summary();
  EXPECT_EQ(keys["formula_face_burst_low_m"], keys["formula_face_burst_high_m"]);
  EXPECT_EQ(keys["formula_flyrock_k_high"], 20.0);
  const double mckenzie = keys["formula_mckenzie_m"];  // farther than the others
  EXPECT_GT(mckenzie, keys["formula_cratering_high_m"].get<double>());
  EXPECT_NEAR(keys["formula_clearance_m"], 3.0 * mckenzie, 1e-6);
}

// Two decks in the front hole, the upper one of half the diameter.
TEST_F(Flyrock, OfAHoleTableLooksAtEachHoleAndDeck) {
  add_to_scene("\"explosive_density_kg_m3\": 1000, \"rock_density_kg_m3\": 2600, ");
  write_text(folder().dump("holes.csv"),
             "hole,collar_x_m,collar_y_m,collar_z_m,toe_x_m,toe_y_m,toe_z_m,diameter_m,"
             "charge_diameter_m,from_m,to_m\n"
             "back,-9,0,10.5,-9,0,-1,0.1,0.1,1.5,11.5\n"
             "front,-5,0,10.5,-5,0,-1,0.1,0.1,6,11.5\n"
             "front,-5,0,10.5,-5,0,-1,0.1,0.05,3,5\n");
  const std::vector<FlyrockHole> holes = flyrock_holes(folder());
  ASSERT_EQ(holes.size(), 2U);
  EXPECT_EQ(holes[0].name, "front");
  EXPECT_NEAR(holes[0].stemming, 3.0, 1e-12);
  EXPECT_NEAR(holes[0].mass_per_metre, 7.85398, 1e-5);
  EXPECT_NEAR(holes[0].top_per_metre, 7.85398 / 4.0, 1e-5);
  EXPECT_NEAR(holes[0].top_length, 2.0, 1e-12);
  EXPECT_TRUE(std::isnan(holes[1].burden));  // no free face before it
  report_flyrock(folder());
  const auto keys = summary();
  // Face burst is of the front hole, cratering of the back one with its short stemming.
  EXPECT_NEAR(keys["formula_face_burst_high_m"], richards_moore_range(30.0, 7.85398, 5.0), 1e-3);
  EXPECT_NEAR(keys["formula_cratering_high_m"], richards_moore_range(30.0, 7.85398, 1.5), 1e-2);
  EXPECT_TRUE(keys["formula_mckenzie_fragment_m"].is_number());
}

constexpr const char* kTableHeader =
    "hole,collar_x_m,collar_y_m,collar_z_m,toe_x_m,toe_y_m,toe_z_m,diameter_m,from_m,to_m,"
    "explosive\n";

TEST_F(Flyrock, OfAHoleWithoutStemmingHasNoClearance) {
  add_to_scene("\"explosive_density_kg_m3\": 1000, ");
  report_flyrock(folder());
  EXPECT_TRUE(summary()["formula_clearance_note"].is_null());
  write_text(folder().dump("holes.csv"), std::string(kTableHeader) +
                                             "a,-5,0,10.5,-5,0,-1,0.1,3,11.5,\n"
                                             "b,-5,2,10.5,-5,2,-1,0.1,0,11.5,\n");
  report_flyrock(folder());
  EXPECT_TRUE(summary()["formula_cratering_high_m"].is_number());  // of the other hole
  EXPECT_TRUE(summary()["formula_clearance_m"].is_null());
  EXPECT_EQ(summary()["formula_clearance_note"], kOpenHoleNote);
}

TEST_F(Flyrock, NeedsTheMassOfEachDeck) {
  add_to_scene("\"explosive_density_kg_m3\": 1000, ");
  write_text(folder().dump("holes.csv"), std::string(kTableHeader) +
                                             "a,-5,0,10.5,-5,0,-1,0.1,3,5,\n"
                                             "a,-5,0,10.5,-5,0,-1,0.1,6,11.5,homemade\n");
  const std::string message = input_error_of([&] { report_flyrock(folder()); });
  EXPECT_NE(message.find("of hole 'a': neither dump/explosives.csv, the shipped explosives nor"),
            std::string::npos)
      << message;
  EXPECT_THROW(report_flyrock(folder()), NotMeasurable);
}

TEST_F(Flyrock, IsMadeWithTheOthersWhereTheChargeIsKnown) {
  const auto has_flyrock = [&] {
    const auto names = reports_of(folder(), false);
    return std::ranges::find(names, "flyrock") != names.end();
  };
  EXPECT_FALSE(has_flyrock());
  add_to_scene("\"explosive_density_kg_m3\": 1000, ");
  EXPECT_TRUE(has_flyrock());
}

TEST_F(Flyrock, OfOtherScenesIsNotMeasured) {
  report_flyrock(folder());
  const auto scene = temporary_.path() / "dump/scene.json";
  std::string text = text_of(scene);
  write_text(scene, text.replace(text.find("bench\""), 5, "other"));
  EXPECT_THROW(report_flyrock(folder()), NotMeasurable);
  EXPECT_FALSE(summary().contains("formula_clearance_m"));
  EXPECT_FALSE(std::filesystem::exists(folder().file("flyrock.csv")));
}

TEST_F(Flyrock, WithoutTheMassOfACharge) {
  write_bench(temporary_.path());
  EXPECT_THROW(report_flyrock(folder()), NotMeasurable);
}

}  // namespace
}  // namespace muckpile
