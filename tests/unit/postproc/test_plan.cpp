// SPDX-License-Identifier: GPL-2.0-or-later
// Contours over scattered points, and the plan of a pattern as picture and keys.
// Scope: measure/contours and report/plan_report.
#include <gtest/gtest.h>

#include "args/input_error.h"
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

TEST_F(Plan, OfAFaultyTableSaysWhere) {
  const std::string table = write("faulty.csv", "a,0,0,9,0,0,0,-1,3,5,0,0\n");
  EXPECT_THROW(report_plan(table), InputError);
}

}  // namespace
}  // namespace muckpile
