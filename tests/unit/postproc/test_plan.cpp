// SPDX-License-Identifier: GPL-2.0-or-later
// Contours over scattered points, and the plan of a pattern as picture and keys.
// Scope: measure/contours and report/plan_report.
#include <gtest/gtest.h>

#include "args/csv_table.h"
#include "args/input_error.h"
#include "input_error_of.h"
#include "measure/burden_relief.h"
#include "measure/contours.h"
#include "report/plan_report.h"
#include "report/reports.h"
#include "temporary_folder.h"

namespace muckpile {
namespace {

std::vector<Vec2> grid(int n) {
  std::vector<Vec2> points;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) points.emplace_back(i + 0.1 * (j % 2), j);
  }
  return points;
}

TEST(Contours, OfALinearFieldAreStraightAndCrossTheHull) {
  const std::vector<Vec2> points = grid(6);
  std::vector<double> values;
  for (const Vec2& p : points) values.push_back(3.0 * p.x() + 1.0);
  double length = 0.0;
  for (const auto& [from, to] : contour(points, values, triangulate(points), 3.0 * 2.55 + 1.0)) {
    EXPECT_NEAR(from.x(), 2.55, 1e-12);
    EXPECT_NEAR(to.x(), 2.55, 1e-12);
    length += (to - from).norm();
  }
  EXPECT_NEAR(length, 5.0, 1e-12);  // from y = 0 to y = 5, nothing twice
}

TEST(Contours, AreEmptyOutsideTheValuesAndForPointsOnALine) {
  const std::vector<Vec2> points = grid(3);
  const std::vector<double> values(points.size(), 1.0);
  EXPECT_TRUE(contour(points, values, triangulate(points), 2.0).empty());
  EXPECT_TRUE(triangulate({{0, 0}, {1, 0}, {2, 0}}).empty());
}

class Plan : public ::testing::Test {
 protected:
  std::string write(const std::string& name, const std::string& rows) {
    return testing::write_text(
        temporary_.path() / name,
        std::string("hole,collar_x_m,collar_y_m,collar_z_m,toe_x_m,toe_y_m,toe_z_m,"
                    "diameter_m,from_m,to_m,surface_delay_s,in_hole_delay_s\n") +
            rows);
  }
  testing::TemporaryFolder temporary_;
  static constexpr const char* kRows =
      "a,0,0,9,0,0,0,0.1,3,5,0,0.025\na,0,0,9,0,0,0,0.1,6,9,0,0\nb,4,0,9,4,0,0,0.1,3,9,0.007,0\n"
      "c,2,3,9,2,3,0,0.1,3,9,0.1,0\n";
};

TEST_F(Plan, OfATableLiesBesideIt) {
  const std::string table = write("holes.csv", kRows);
  const auto picture = std::filesystem::path(table).replace_extension(".png");
  report_plan(table);
  EXPECT_GT(std::filesystem::file_size(picture), 5000u);
}

TEST_F(Plan, NeverReplacesTheTable) {
  const std::string table = write("holes.png", kRows);
  EXPECT_THROW(report_plan(table), InputError);
  EXPECT_TRUE(testing::text_of(table).starts_with("hole,"));
}

TEST_F(Plan, OfAResultFolderAddsItsKeys) {
  write("dump/holes.csv", kRows);
  const std::filesystem::path& folder = temporary_.path();
  testing::write_text(folder / "dump/scene.json", "{\"case\": \"bench\"}");
  report_plan(folder);
  const auto keys = read_json_object(folder / "summary.json");
  EXPECT_EQ(keys["pattern_holes"], 3);
  EXPECT_EQ(keys["pattern_decks"], 4);
  EXPECT_EQ(keys["first_firing_s"], 0.0);
  EXPECT_EQ(keys["last_firing_s"], 0.1);
  EXPECT_EQ(keys["most_decks_within_8_ms"], 2);  // 0 and 7 ms; 25 and 100 ms are alone
  EXPECT_TRUE(std::filesystem::exists(folder / "plan.png"));
}

// Two staggered rows of three; rows 2.5 m apart, 3 m between holes, 17 ms along a row, 42 ms to the
// next one, whose first hole fires too early.
const char* const kTwoRows =
    "a1,-2.5,-3,9,-2.5,-3,0,0.1,3,9,0,0\na2,-2.5,0,9,-2.5,0,0,0.1,3,9,0.017,0\n"
    "a3,-2.5,3,9,-2.5,3,0,0.1,3,9,0.034,0\nb1,-5,-1.5,9,-5,-1.5,0,0.1,3,9,0,0\n"
    "b2,-5,1.5,9,-5,1.5,0,0.1,3,9,0.059,0\nb3,-5,4.5,9,-5,4.5,0,0.1,3,9,0.076,0\n";

TEST_F(Plan, HasTheReliefOfEachHole) {
  write("dump/holes.csv", kTwoRows);
  const std::filesystem::path& folder = temporary_.path();
  testing::write_text(folder / "dump/scene.json",
                      "{\"case\": \"bench\", \"explosive_density_kg_m3\": 800, \"terrain\": "
                      "\"t.csv\", \"terrain_east_m\": 1000, \"terrain_north_m\": 2000, "
                      "\"terrain_height_m\": 0, \"x_bearing_deg\": 90}");
  report_plan(folder);
  // Charges of pi 0.05^2 6 m x 800 kg/m3. b2 fires towards a3, which fires after a2, but both are
  // sqrt(2.5^2 + 1.5^2) = 2.91548 m away: the first of them, a2, 42 ms before it. b1 has a1 and a2
  // in front: neither has fired before, a1 fires at the same time. b3 has a3, 42 ms before.
  EXPECT_EQ(whole_file(folder / "plan.csv"),
            "hole,in_front,x_m,y_m,fires_s,charge_kg,burden_m,relief_ms_per_m,within_8_ms_kg,"
            "east_m,north_m\n"
            "a1,,-2.5,-3,0,37.6991,,,75.3982,997.500,1997.000\n"
            "a2,,-2.5,0,0.017,37.6991,,,37.6991,997.500,2000.000\n"
            "a3,,-2.5,3,0.034,37.6991,,,37.6991,997.500,2003.000\n"
            "b1,a1,-5,-1.5,0,37.6991,2.91548,0,75.3982,995.000,1998.500\n"
            "b2,a2,-5,1.5,0.059,37.6991,2.91548,14.4059,37.6991,995.000,2001.500\n"
            "b3,a3,-5,4.5,0.076,37.6991,2.91548,14.4059,37.6991,995.000,2004.500\n");
  EXPECT_EQ(read_json_object(folder / "summary.json")["burden_relief_least_ms_per_m"], 0.0);
}

TEST(BurdenRelief, TheFaceCountsWhereItIsNearerAndHolesBesideDoNot) {
  std::vector<ReliefHole> holes{
      {{-2.0, 0.0}, 0.0, 2.0}, {{-2.0, 1.5}, 0.05, 2.1}, {{-4.0, 0.0}, 0.1, std::nullopt}};
  std::vector<Relief> reliefs = burden_relief(holes);
  EXPECT_FALSE(reliefs[1].in_front);  // the first one stands beside it
  EXPECT_EQ(*reliefs[1].burden, 2.1);
  EXPECT_FALSE(reliefs[1].per_metre);
  EXPECT_EQ(*reliefs[2].in_front, 0u);
  EXPECT_NEAR(*reliefs[2].per_metre, 0.1 / 2.0, 1e-12);
  // the hole before it fires late: the other one, 37 degrees aside, has fired
  holes[0].time = 0.2;
  reliefs = burden_relief(holes);
  EXPECT_EQ(*reliefs[2].in_front, 1u);
  EXPECT_NEAR(*reliefs[2].per_metre, 0.05 / 2.5, 1e-12);
  holes[1].time = 0.3;  // so does this one
  EXPECT_EQ(*burden_relief(holes)[2].in_front, 0u);
  EXPECT_NEAR(*burden_relief(holes)[2].per_metre, -0.1 / 2.0, 1e-12);
  holes[2].face = 1.9;
  EXPECT_FALSE(burden_relief(holes)[2].in_front);
}

TEST_F(Plan, OfAFaultyTableSaysWhere) {
  const std::string table = write("faulty.csv", "a,0,0,9,0,0,0,-1,3,5,0,0\n");
  EXPECT_THROW(report_plan(table), InputError);
  const std::string empty = write("empty.csv", "");
  EXPECT_EQ(input_error_of([&] { report_plan(empty); }), empty + ": has no row");
}

}  // namespace
}  // namespace muckpile
