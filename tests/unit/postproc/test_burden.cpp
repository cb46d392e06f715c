// SPDX-License-Identifier: GPL-2.0-or-later
// Burdens of made-up holes: table, keys and picture, and what is refused.
// Scope: report/burden_report, report/burden_plot.
#include <gtest/gtest.h>

#include "args/csv_table.h"
#include "golden_files.h"
#include "input_error_of.h"
#include "io/result_folder.h"
#include "report/burden_report.h"
#include "report/not_measurable.h"
#include "rock/burden_file.h"
#include "temporary_folder.h"

namespace muckpile {
namespace {

using namespace testing;

constexpr const char* kRun = "0123456789abcdef";

// Two decks of hole A, 1.5 and 2.5 m behind the face x = 0; hole B, 3 m behind A.
BurdenFile burdens() {
  BurdenFile all;
  all.plan = 3.0;
  all.holes.resize(3);
  all.holes[0].pieces = {{0.5, Vec3(-1.5, 2.0, 1.0), 1.5, Vec3(0.0, 2.0, 1.0)}};
  all.holes[1].pieces = {{0.5, Vec3(-2.5, 2.0, 4.0), 2.5, Vec3(0.0, 2.0, 4.0)}};
  all.holes[2].pieces = {{0.5, Vec3(-4.5, 2.0, 1.0), 4.5, Vec3(0.0, 2.0, 1.0)},
                         {1.5, Vec3(-4.5, 2.0, 2.0), std::nullopt, Vec3::Zero()}};
  all.holes[2].in_front = 0;
  all.holes[2].to_front = 4.8;
  return all;
}

class Burden : public ::testing::Test {
 protected:
  void SetUp() override {
    write_burdens((temporary_.path() / "dump/burden.csv").string(), burdens(), kRun);
    write_scene("");
    write_text(temporary_.path() / "dump/holes.csv",
               "hole,collar_x_m,collar_y_m,collar_z_m,toe_x_m,toe_y_m,toe_z_m,diameter_m,from_m,"
               "to_m\nA,-2,2,9,-2,2,0,0.1,7,9\nA,-2,2,9,-2,2,0,0.1,3,6\nB,-5,2,9,-5,2,0,0.1,3,9\n");
  }
  void write_scene(const std::string& more) const {
    write_text(temporary_.path() / "dump/scene.json",
               std::string("{\"case\": \"bench\", \"run_id\": \"") + kRun + "\"" + more + "}");
  }
  [[nodiscard]] ResultFolder folder() const { return ResultFolder(temporary_.path()); }
  [[nodiscard]] CsvTable table() const { return CsvTable::read(folder().file("burden.csv")); }
  TemporaryFolder temporary_;
};

TEST_F(Burden, TheTableIsTheGoldenOne) {
  report_burden(folder());
  expect_golden(folder().file("burden.csv"), "holes_burden");
}

TEST_F(Burden, IsJudgedHoleByHole) {
  report_burden(folder());
  const CsvTable csv = table();
  ASSERT_EQ(csv.rows(), 4U);
  const auto word = [&](size_t row, const char* column) {
    return std::string(csv.word(row, csv.column(column)));
  };
  EXPECT_EQ(word(0, "hole"), "A");
  EXPECT_EQ(word(0, "verdict"), "too_little");  // 1.5 < 0.6 * 3
  EXPECT_EQ(word(1, "hole"), "A");
  EXPECT_EQ(word(1, "verdict"), "as_planned");
  EXPECT_EQ(word(2, "hole"), "B");
  EXPECT_EQ(word(2, "in_front"), "A");
  EXPECT_EQ(word(2, "burden_m"), "4.5");
  EXPECT_EQ(word(2, "verdict"), "as_planned");
  EXPECT_EQ(word(3, "burden_m"), "4.8");  // no face is there: the way to the hole in front
  EXPECT_EQ(word(3, "to_face_m"), "");
  EXPECT_EQ(word(3, "face_x_m"), "");
  EXPECT_EQ(word(3, "verdict"), "too_much");
  EXPECT_FALSE(csv.find_column("east_m"));
  const auto keys = read_json_object(folder().file("summary.json"));
  EXPECT_EQ(keys["burden_plan_m"], 3.0);
  EXPECT_EQ(keys["burden_least_m"], 1.5);
  EXPECT_EQ(keys["burden_greatest_m"], 4.8);
  EXPECT_EQ(keys["holes_burden_too_little"], 1);
  EXPECT_EQ(keys["holes_burden_too_much"], 1);
  EXPECT_GT(std::filesystem::file_size(folder().file("burden.png")), 5000U);
}

// x looks north, so y looks west.
TEST_F(Burden, HasPlacesOfTheMine) {
  write_scene(
      ", \"terrain_east_m\": 5000, \"terrain_north_m\": 7000, \"terrain_height_m\": 100, "
      "\"x_bearing_deg\": 0");
  report_burden(folder());
  const CsvTable csv = table();
  const auto number = [&](const char* column) { return csv.number(0, csv.column(column)); };
  EXPECT_EQ(number("east_m"), 4998.0);
  EXPECT_EQ(number("north_m"), 6998.5);
  EXPECT_EQ(number("elevation_m"), 101.0);
  EXPECT_EQ(number("face_east_m"), 4998.0);
  EXPECT_EQ(number("face_north_m"), 7000.0);
  EXPECT_EQ(number("face_elevation_m"), 101.0);
}

TEST_F(Burden, WithoutAPlanIsDrawnAndNotJudged) {
  BurdenFile all = burdens();
  all.plan = 0.0;
  write_burdens((temporary_.path() / "dump/burden.csv").string(), all, kRun);
  std::filesystem::remove(temporary_.path() / "dump/holes.csv");
  report_burden(folder());
  EXPECT_EQ(table().word(0, table().column("hole")), "1");
  EXPECT_EQ(table().word(0, table().column("verdict")), "");
  const auto keys = read_json_object(folder().file("summary.json"));
  EXPECT_TRUE(keys["burden_plan_m"].is_null());
  EXPECT_TRUE(keys["holes_burden_too_little"].is_null());
  EXPECT_TRUE(std::filesystem::exists(folder().file("burden.png")));
}

TEST_F(Burden, OfAnotherRunOrOfNoneIsRefused) {
  write_burdens((temporary_.path() / "dump/burden.csv").string(), burdens(), "fedcba9876543210");
  EXPECT_NE(input_error_of([&] { (void)folder(); }).find("files of two runs"), std::string::npos);
  std::filesystem::remove(temporary_.path() / "dump/burden.csv");
  EXPECT_THROW(report_burden(folder()), NotMeasurable);
}

TEST_F(Burden, OfARunWithoutHolesTakesBackWhatWasThere) {
  report_burden(folder());
  write_burdens((temporary_.path() / "dump/burden.csv").string(), {}, kRun);
  EXPECT_THROW(report_burden(folder()), NotMeasurable);
  EXPECT_FALSE(std::filesystem::exists(folder().file("burden.csv")));
  EXPECT_FALSE(std::filesystem::exists(folder().file("burden.png")));
}

}  // namespace
}  // namespace muckpile
