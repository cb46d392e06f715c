// SPDX-License-Identifier: GPL-2.0-or-later
// Measures that hold for any geometry, against shapes worked out by hand: power trough, sections
// and overthrow along a line, volumes, end holes, mine coordinates.
// Scope: measure/trough, measure/plan_line, io/mine_frame and the reports made of them.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "args/csv_table.h"
#include "input_error_of.h"
#include "io/mine_frame.h"
#include "measure/plan_line.h"
#include "measure/section.h"
#include "measure/survey_heights.h"
#include "measure/trough.h"
#include "report/mine_pose.h"
#include "report/not_measurable.h"
#include "report/reports.h"
#include "report/run_section.h"
#include "synthetic_run.h"

namespace muckpile {
namespace {

using namespace testing;

// A surface with straight lines between points (x, z), a sample each 0.1 m.
struct Surface {
  explicit Surface(const std::vector<Vec2>& corners) {
    const auto steps =
        static_cast<int>(std::lround((corners.back().x() - corners.front().x()) / 0.1));
    size_t k = 0;
    for (int i = 0; i <= steps; ++i) {
      x.push_back(corners.front().x() + 0.1 * i);
      while (k + 2 < corners.size() && x.back() > corners[k + 1].x()) ++k;
      const double share = (x.back() - corners[k].x()) / (corners[k + 1].x() - corners[k].x());
      z.push_back(corners[k].y() + share * (corners[k + 1].y() - corners[k].y()));
    }
  }
  std::vector<double> x, z;
};

// From the bench at 10 m down by 2 in 1 to 4 m at x = 3, up by 1 in 1 to the pile at x = 6, and
// out.
TEST(Trough, IsTheValleyBehindAPileBelowTheBench) {
  const Surface s({{-2, 10}, {0, 10}, {3, 4}, {6, 7}, {13, 0}, {15, 0}});
  const Trough trough = deepest_trough(s.x, s.z, 0.5);
  EXPECT_NEAR(trough.depth, 7.0 - 4.0, 1e-9);
  EXPECT_NEAR(trough.x, 3.0, 1e-9);
  EXPECT_NEAR(trough.z, 4.0, 1e-9);
  EXPECT_NEAR(trough.rim, 7.0, 1e-9);
  EXPECT_NEAR(trough.back, 1.5, 1e-9);  // 10 - 2 x = 7
  EXPECT_NEAR(trough.front, 6.0, 1e-9);
  EXPECT_NEAR(trough.width, 4.5, 1e-9);
  EXPECT_NEAR(trough.area, 0.5 * 4.5 * 3.0, 1e-9);
  EXPECT_NEAR(trough.crest, 7.0, 1e-9);
}

// The pile is 12 m high: the bench's edge is the lower rim, and the pile's back is at 10 m at x
// = 9.
TEST(Trough, OfAPileAboveTheBenchIsFilledToTheBench) {
  const Surface s({{-2, 10}, {0, 10}, {3, 4}, {11, 12}, {23, 0}});
  const Trough trough = deepest_trough(s.x, s.z, 0.5);
  EXPECT_NEAR(trough.depth, 6.0, 1e-9);
  EXPECT_NEAR(trough.back, 0.0, 1e-9);
  EXPECT_NEAR(trough.front, 9.0, 1e-9);
  EXPECT_NEAR(trough.area, 0.5 * 9.0 * 6.0, 1e-9);
  EXPECT_NEAR(trough.crest, 12.0, 1e-9);
}

// A ditch of 5 m in the ground, 2 m beyond the toe: the pile's trough is the same without it.
TEST(Trough, IsNotADitchOfTheGroundBeyondThePile) {
  const Surface s(
      {{-2, 10}, {0, 10}, {3, 4}, {6, 7}, {13, 0}, {15, 0}, {17, -5}, {19, 0}, {25, 0}});
  Surface ground({{-2, 0}, {15, 0}, {17, -5}, {19, 0}, {25, 0}});
  EXPECT_NEAR(deepest_trough(s.x, s.z, 0.5).depth, 5.0, 1e-9);
  EXPECT_NEAR(deepest_trough(s.x, s.z, ground.z, 0.5).depth, 3.0, 1e-9);
  EXPECT_NEAR(deepest_trough(s.x, s.z, ground.z, 0.5).x, 3.0, 1e-9);
  std::ranges::fill(ground.z, std::nan(""));
  EXPECT_NEAR(deepest_trough(s.x, s.z, ground.z, 0.5).depth, 5.0, 1e-9);
}

TEST(Trough, IsNoneWhereThePileLeansOnTheBench) {
  const Surface s({{-2, 10}, {0, 10}, {15, 0}, {20, 0}});
  const Trough trough = deepest_trough(s.x, s.z, 0.5);
  EXPECT_EQ(trough.depth, 0.0);
  EXPECT_EQ(trough.width, 0.0);
  EXPECT_EQ(trough.area, 0.0);
  EXPECT_TRUE(std::isnan(trough.x));
}

TEST(Trough, IsNoneWhereValleysAreAsShallowAsThePitsBetweenBlocks) {
  const Surface s({{-2, 10}, {0, 10}, {3, 8}, {3.5, 8.4}, {12, 0}});
  EXPECT_EQ(deepest_trough(s.x, s.z, 0.5).depth, 0.0);
  EXPECT_NEAR(deepest_trough(s.x, s.z, 0.3).depth, 0.4, 1e-9);
}

TEST(PlanLine, SeesRockAlongItself) {
  // Towards +y from (2, 1): along is y - 1, left is 2 - x.
  const PlanLine line{{2.0, 1.0}, {2.0, 5.0}};
  EXPECT_NEAR((line.along_and_left({1.5, 3.0}) - Vec2(2.0, 0.5)).norm(), 0.0, 1e-12);
  EXPECT_NEAR((line.at(3.0) - Vec2(2.0, 4.0)).norm(), 0.0, 1e-12);
  const auto blocks = as_start_blocks({cube_at({1.75, 3.0, 0.0})});
  const auto cut = section_at(0.0, blocks, seen_along(line, start_snapshot(blocks).states));
  ASSERT_EQ(cut.size(), 1U);
  for (const Vec2& p : cut[0].outline) {
    EXPECT_NEAR(std::abs(p.x() - 2.25), 0.25, 1e-12);  // y from 3 to 3.5
    EXPECT_NEAR(std::abs(p.y() - 0.25), 0.25, 1e-12);
  }
}

// Columns of the pile from x = 5 on have 9, 9, 8, 8 ... 1, 1 cubes: 90 in each of 4 rows.
TEST(OverLine, CountsWhatStartedBehindAndLiesBeyond) {
  const BenchRun run = bench_run();
  const std::vector<char> lies(run.blocks.size(), 1);
  for (const PlanLine& line : {PlanLine{{5, -3}, {5, 7}}, PlanLine{{5, 7}, {5, -3}}}) {
    const OverLine over = over_line(line, run.blocks, run.last, lies);
    EXPECT_EQ(over.pieces.size(), 360U);
    EXPECT_NEAR(over.volume, 360 * 0.125, 1e-9);
    EXPECT_NEAR(over.mass, 360 * 0.125 * kDensity, 1e-6);
    EXPECT_NEAR(over.pieces.front().distance, 13.75 - 5.0, 1e-9);
  }
  EXPECT_TRUE(over_line({{20, 0}, {20, 1}}, run.blocks, run.last, lies).pieces.empty());
}

TEST(MineFrame, TurnsXToItsBearing) {
  // Towards north: y, to the left, is west.
  const MineFrame north{{355000.0, 6200000.0, 412.0}, 0.0};
  EXPECT_NEAR((north.of({2.0, 1.0, 3.0}) - Vec3(354999.0, 6200002.0, 415.0)).norm(), 0.0, 1e-8);
  const MineFrame frame{{355000.0, 6200000.0, 412.0}, 292.0 * std::numbers::pi / 180.0};
  const Vec3 local(7.0, -4.0, 2.0);
  EXPECT_NEAR((frame.back(frame.of(local)) - local).norm(), 0.0, 1e-8);
  // West-north-west: east falls and north rises along the throw.
  EXPECT_LT(frame.of({1, 0, 0}).x(), 355000.0);
  EXPECT_GT(frame.of({1, 0, 0}).y(), 6200000.0);
}

// The quarry writes the keys in any case; a plan of Kirra turns its axes without placing them.
TEST(MineFrame, IsNoneWhereNothingWasPlaced) {
  TemporaryFolder temporary;
  write_heap(temporary.path());
  const auto scene = [&](const std::string& terrain) {
    write_text(temporary.path() / "dump/scene.json",
               "{\"case\": \"heap\", \"terrain\": \"" + terrain +
                   "\", \"terrain_east_m\": 0, \"terrain_north_m\": 0, "
                   "\"terrain_height_m\": 0, \"x_bearing_deg\": 292}");
    return ResultFolder(temporary.path());
  };
  EXPECT_FALSE(mine_frame(scene("none")).has_value());
  EXPECT_TRUE(mine_frame(scene("survey.csv")).has_value());
}

TEST(MineFrame, PoseOfFilesIsTheWayBackFromTheMine) {
  TemporaryFolder temporary;
  write_heap(temporary.path());
  write_text(temporary.path() / "dump/scene.json",
             "{\"case\": \"heap\", \"terrain_east_m\": 355000, \"terrain_north_m\": 6200000, "
             "\"terrain_height_m\": 412, \"x_bearing_deg\": 292}");
  const ResultFolder folder(temporary.path());
  std::array<double, 3> shift{};
  double turn = 0.0;
  set_mine_pose(folder, "survey", shift, turn);
  const SurveyPose pose{{shift[0], shift[1], shift[2]}, turn * std::numbers::pi / 180.0};
  EXPECT_TRUE(std::isnan(mine_place(mine_frame(folder), std::nan(""), 1.0)[1]));
  const Vec3 local(7.0, -4.0, 2.0);
  EXPECT_NEAR((pose.of(mine_frame(folder)->of(local)) - local).norm(), 0.0, 1e-8);
}

class Lines : public ::testing::Test {
 protected:
  void SetUp() override { write_bench(temporary_.path()); }
  [[nodiscard]] ResultFolder folder() const { return ResultFolder(temporary_.path()); }
  [[nodiscard]] nlohmann::ordered_json summary() const {
    return read_json_object(folder().file("summary.json"));
  }
  [[nodiscard]] CsvTable table(const std::string& name) const {
    return CsvTable::read(folder().file(name));
  }
  void add_to_scene(const std::string& keys) const {
    const auto path = folder().dump("scene.json");
    std::string text = text_of(path);
    write_text(path, text.insert(1, keys + ", "));
  }
  TemporaryFolder temporary_;
  MeasureOptions measure_{kCube, 0.25};
};

TEST_F(Lines, SectionAlongTheThrowHasTheHeightsOfBenchAndPile) {
  LineOptions line;
  line.from = {-8.0, 0.3};
  line.to = {15.0, 0.3};
  report_section(folder(), measure_, line);
  const CsvTable rows = table("section.csv");
  ASSERT_EQ(rows.rows(), 92U);
  EXPECT_NEAR(rows.number(10, rows.column("before_m")), kBenchHeight, 1e-6);
  EXPECT_NEAR(rows.number(10, rows.column("after_m")), kBenchHeight, 1e-6);
  EXPECT_NEAR(rows.number(10, rows.column("x_m")), -8.0 + 10.5 * 0.25, 1e-5);
  EXPECT_NEAR(rows.number(33, rows.column("after_m")), kSteps * kLayer, 1e-5);  // x = 0.375
  EXPECT_NEAR(rows.number(33, rows.column("rock_in_place_m")), 0.0, 1e-9);
  // The prism, 5 m by 10.5 m, and 210 cubes of the pile, each 0.5 m by 0.65 m.
  EXPECT_NEAR(summary()["section_cut_area_m2"], 52.5, 1e-6);
  EXPECT_NEAR(summary()["section_fill_area_m2"], 210 * 0.5 * kLayer, 1e-6);
  EXPECT_NEAR(summary()["section_trough_depth_m"], kSteps * kLayer, 1e-6);
  EXPECT_NEAR(summary()["section_trough_width_m"], kBurden, 0.25);
  EXPECT_GT(std::filesystem::file_size(folder().file("section.png")), 2000U);
}

// The floor falls by 1 in 10 from the toe on, and each cube of the pile lies as much lower as at
// its middle. Where rock has gone the floor is that of the toe, whatever the rock stands on.
TEST_F(Lines, SectionOverASlopeHasItsFloor) {
  put_on_slope(temporary_.path(), 0.1);
  LineOptions line;
  line.from = {-8.0, 0.3};
  line.to = {20.0, 0.3};
  report_section(folder(), measure_, line);
  const CsvTable rows = table("section.csv");
  ASSERT_EQ(rows.rows(), 112U);
  const auto at = [&](size_t row, const char* name) { return rows.number(row, rows.column(name)); };
  EXPECT_NEAR(at(20, "after_m"), 0.0, 1e-9);  // x = -2.875
  // x = 6.125, in the column of 8 cubes from 6 to 6.5 m.
  EXPECT_NEAR(at(56, "before_m"), -0.6125, 1e-6);
  EXPECT_NEAR(at(56, "after_m"), 8 * kLayer - 0.625, 1e-6);
  EXPECT_NEAR(at(56, "rock_in_place_m"), -0.6125, 1e-6);
  EXPECT_NEAR(at(111, "after_m"), -1.9875, 1e-6);  // bare at x = 19.875
  // As on a level floor: a cube's columns lie as far in front of its middle as behind it.
  EXPECT_NEAR(summary()["section_cut_area_m2"], 52.5, 1e-6);
  EXPECT_NEAR(summary()["section_fill_area_m2"], 210 * 0.5 * kLayer, 1e-5);
  EXPECT_NEAR(summary()["section_trough_depth_m"], kSteps * kLayer - 0.025, 1e-6);
}

// Along the row, 1 m beyond the toe of the pile: ground alone is no rock.
TEST_F(Lines, SectionOverBareGroundIsRefused) {
  put_on_slope(temporary_.path(), 0.1);
  LineOptions line;
  line.from = {15.0, -0.9};
  line.to = {15.0, 0.9};
  EXPECT_NE(input_error_of([&] { report_section(folder(), measure_, line); }).find("meets no rock"),
            std::string::npos);
}

TEST_F(Lines, SectionAcrossTheThrowRunsAlongTheRow) {
  LineOptions line;
  line.from = {3.2, 1.0};
  line.to = {3.2, -1.0};
  report_section(folder(), measure_, line);
  const CsvTable rows = table("section.csv");
  ASSERT_EQ(rows.rows(), 8U);
  // Columns 6 and 7 of the pile, of 11 cubes.
  for (size_t row = 0; row < rows.rows(); ++row)
    EXPECT_NEAR(rows.number(row, rows.column("after_m")), 11 * kLayer, 1e-5);
  EXPECT_NEAR(rows.number(0, rows.column("y_m")), 0.875, 1e-6);
}

TEST(ChargeBars, StandWhereTheLineMeetsAHole) {
  // along y at x = -3: the first hole leans through the line, the second stands 0.4 m beside it
  const PlanLine line{{-3.0, -5.0}, {-3.0, 5.0}};
  const std::vector<Charge> charges{{{-2.5, 1.0, 0.0}, {-4.5, 1.0, 8.0}, 0.2},
                                    {{-3.4, 2.0, 0.0}, {-3.4, 2.0, 8.0}, 0.2},
                                    {{-3.0, 8.0, 0.0}, {-3.0, 8.0, 8.0}, 0.2}};  // beyond its end
  const std::vector<SectionBar> bars = charge_bars(line, charges, 0.0, 0.05);
  ASSERT_EQ(bars.size(), 1U);
  EXPECT_LT((bars[0].low - Vec2(6.0, 0.0)).norm(), 1e-12);  // 6 m from the line's start
  EXPECT_LT((bars[0].high - Vec2(6.0, 8.0)).norm(), 1e-12);
  EXPECT_EQ(bars[0].half, 0.05);
  EXPECT_EQ(charge_bars(line, charges, 0.5, 0.05).size(), 2U);
  EXPECT_EQ(charge_bars(line, charges, 0.5, std::nan(""))[1].half, 0.2);
}

TEST_F(Lines, SectionInMineCoordinatesIsThatOfTheRun) {
  add_to_scene(
      "\"terrain_east_m\": 355000, \"terrain_north_m\": 6200000, \"terrain_height_m\": 412, "
      "\"x_bearing_deg\": 0");
  LineOptions line;
  line.mine = true;
  line.from = {354999.7, 6199992.0};  // x = -8, y = 0.3
  line.to = {354999.7, 6200015.0};
  report_section(folder(), measure_, line);
  const CsvTable rows = table("section.csv");
  EXPECT_NEAR(summary()["section_fill_area_m2"], 210 * 0.5 * kLayer, 1e-6);
  EXPECT_EQ(rows.word(0, rows.column("north_m")), "6199992.125");
  EXPECT_EQ(rows.word(0, rows.column("east_m")), "354999.700");
}

// x looks north, so y looks west: east = 355000 - y, north = 6200000 + x, elevation = 412 + z.
TEST_F(Lines, MovementAndFragmentsHavePlacesOfTheMine) {
  report_movement(folder(), measure_, {});
  EXPECT_FALSE(table("movement.csv").find_column("start_east_m"));
  add_to_scene(
      "\"terrain_east_m\": 355000, \"terrain_north_m\": 6200000, \"terrain_height_m\": 412, "
      "\"x_bearing_deg\": 0");
  FragmentOptions options;
  options.boulder = 0.1;
  report_movement(folder(), measure_, {});
  // the first part's start in the drawing, behind the group codes of its layer and of x
  const CsvTable moved = table("movement.csv");
  const std::string drawing = whole_file(folder().file("movement.dxf"));
  const double east = std::stod(drawing.substr(drawing.find("level_1\n10\n") + 11));
  EXPECT_NEAR(east, moved.number(0, moved.column("start_east_m")), 1e-3);
  report_fragments(folder(), measure_, options);
  const auto expect_places = [&](const char* name, const std::string& prefix) {
    SCOPED_TRACE(name + prefix);
    const CsvTable rows = table(name);
    ASSERT_GT(rows.rows(), 0U);
    const auto number = [&](size_t row, const char* column) {
      return rows.number(row, rows.column(prefix + column));
    };
    for (size_t row = 0; row < rows.rows(); ++row) {
      constexpr double kLastDigit = 1e-3;  // of the places
      EXPECT_NEAR(number(row, "east_m"), 355000.0 - number(row, "y_m"), kLastDigit);
      EXPECT_NEAR(number(row, "north_m"), 6200000.0 + number(row, "x_m"), kLastDigit);
      EXPECT_NEAR(number(row, "elevation_m"), 412.0 + number(row, "z_m"), kLastDigit);
    }
  };
  expect_places("movement.csv", "start_");
  expect_places("movement.csv", "end_");
  expect_places("fragments_list.csv", "");
  expect_places("boulders.csv", "");
  EXPECT_GT(std::filesystem::file_size(folder().file("boulders.png")), 1000U);
}

TEST_F(Lines, FaultyLinesAreRefused) {
  LineOptions line;
  EXPECT_NE(input_error_of([&] {
              report_over(folder(), measure_, line);
            }).find("over: --from and --to must be two points, got '0 0' twice"),
            std::string::npos);
  line.to = {0.0, 1.0};
  line.mine = true;
  EXPECT_NE(input_error_of([&] {
              report_section(folder(), measure_, line);
            }).find("section: --mine needs the run's place in the mine, terrain_east_m"),
            std::string::npos);
  line.mine = false;
  line.from = {100.0, 0.0};
  line.to = {110.0, 0.0};
  EXPECT_NE(input_error_of([&] {
              report_section(folder(), measure_, line);
            }).find("meets no rock, which lies from x = -8 to 14 m"),
            std::string::npos);
  line.width = 1e9;
  EXPECT_NE(input_error_of([&] {
              report_section(folder(), measure_, line);
            }).find("section: --width must be at most 1e4 m, got '1e+09'"),
            std::string::npos);
  line.from = {600000.0, 7100000.0};
  line.to = {600010.0, 7100000.0};
  EXPECT_NE(input_error_of([&] {
              report_over(folder(), measure_, line);
            }).find("must lie within 10 km of the rock, got 7125 km; places in the mine are"),
            std::string::npos);
}

TEST_F(Lines, VolumeOverALineIsThatOfThePileBeyond) {
  LineOptions line;
  line.from = {5.0, 0.0};
  line.to = {5.0, 1.0};
  report_over(folder(), measure_, line);
  EXPECT_NEAR(summary()["over_volume_m3"], 45.0, 1e-6);
  EXPECT_NEAR(summary()["over_bulk_volume_m3"], 45.0 * kLayer / kCube, 1e-6);
  EXPECT_NEAR(summary()["over_share_of_moved"], 45.0 / 105.0, 1e-9);
  EXPECT_NEAR(summary()["over_farthest_m"], 8.75, 1e-6);
  const CsvTable rows = table("over.csv");
  EXPECT_EQ(rows.rows(), 21U);
  EXPECT_NEAR(rows.number(0, rows.column("volume_m3")), 45.0, 1e-4);
  EXPECT_NEAR(rows.number(20, rows.column("volume_m3")), 4 * 0.125, 1e-6);  // the last column
  // That has a cube in each of the four rows, from x = 13.5 on.
  EXPECT_NEAR(rows.number(20, rows.column("x_m")), 13.75, 1e-4);
  EXPECT_NEAR(rows.number(20, rows.column("y_m")), 0.0, 1e-6);
  EXPECT_NEAR(rows.number(20, rows.column("z_m")), kLayer - 0.25, 1e-6);
  // Columns of n cubes at 5 + 9 - n + 0.25 and 0.75 m: the sum of 2 n (14.5 - n) over 90 cubes.
  double moment = 0.0;
  for (int n = 1; n <= 9; ++n) moment += 2.0 * n * (14.5 - n);
  EXPECT_NEAR(rows.number(0, rows.column("x_m")), moment / 90.0, 1e-4);
  EXPECT_FALSE(rows.find_column("east_m"));
}

// x looks north, so y looks west.
TEST_F(Lines, RockOverALineHasPlacesOfTheMine) {
  add_to_scene(
      "\"terrain_east_m\": 355000, \"terrain_north_m\": 6200000, \"terrain_height_m\": 412, "
      "\"x_bearing_deg\": 0");
  LineOptions line;
  line.from = {5.0, 0.0};
  line.to = {5.0, 1.0};
  report_over(folder(), measure_, line);
  const CsvTable rows = table("over.csv");
  EXPECT_EQ(rows.word(20, rows.column("east_m")), "355000.000");
  EXPECT_EQ(rows.word(20, rows.column("north_m")), "6200013.750");
  EXPECT_EQ(rows.word(20, rows.column("elevation_m")), "412.400");
  line.from = {20.0, 0.0};  // nothing is there
  line.to = {20.0, 1.0};
  report_over(folder(), measure_, line);
  EXPECT_EQ(whole_file(folder().file("over.csv")),
            "beyond_m,volume_m3,mass_kg,x_m,y_m,z_m,east_m,north_m,elevation_m\n0,0,0,,,,,,\n");
}

// The prism has gone: between the wall at x = -5 and the pile at x = 0 the floor is bare.
TEST_F(Lines, TroughOfTheBenchReachesFromTheNewFaceToThePile) {
  TroughOptions options;
  options.strip = 1.0;
  report_trough(folder(), measure_, options);
  EXPECT_EQ(summary()["trough_sections"], 2);
  EXPECT_EQ(summary()["trough_sections_with"], 2);
  EXPECT_NEAR(summary()["trough_depth_m"], kSteps * kLayer, 1e-6);
  EXPECT_NEAR(summary()["trough_below_bench_largest_m"], kBenchHeight, 1e-6);
  EXPECT_NEAR(summary()["trough_width_m"], kBurden, 0.25);
  EXPECT_NEAR(summary()["trough_volume_m3"], 2.0 * kBurden * kSteps * kLayer, 4.0);
  const CsvTable rows = table("trough.csv");
  ASSERT_EQ(rows.rows(), 2U);
  EXPECT_NEAR(rows.number(1, rows.column("y_low_m")), 0.0, 1e-9);
  EXPECT_NEAR(rows.number(0, rows.column("back_x_m")), -kBurden, 0.13);
  EXPECT_NEAR(rows.number(0, rows.column("pile_height_m")), kSteps * kLayer, 1e-5);
  EXPECT_GT(std::filesystem::file_size(folder().file("trough.png")), 2000U);
}

TEST_F(Lines, TroughOfARunInMotionIsNotMeasured) {
  const auto path = folder().dump("run.json");
  std::string text = text_of(path);
  const std::string still = "\"still\": true";
  write_text(path, text.replace(text.find(still), still.size(), "\"still\": false"));
  EXPECT_THROW(report_trough(folder(), measure_), NotMeasurable);
}

TEST_F(Lines, VolumesBeforeAndAfterAreThoseOfBenchAndPile) {
  report_heights(folder(), measure_);
  EXPECT_NEAR(summary()["volume_before_m3"], 8.0 * 2.0 * kBenchHeight, 1e-6);
  EXPECT_NEAR(summary()["cut_volume_m3"], 5.0 * 2.0 * kBenchHeight, 1e-6);
  EXPECT_NEAR(summary()["fill_volume_m3"], 105.0 * kLayer / kCube, 1e-6);
  EXPECT_NEAR(summary()["volume_after_m3"], 3.0 * 2.0 * kBenchHeight + 136.5, 1e-6);
}

// Three holes in a row; the cubes at the ends stayed where they were.
TEST_F(Lines, EndHolesAreComparedWithInnerOnes) {
  write_text(folder().dump("holes.csv"),
             "hole,collar_x_m,collar_y_m,collar_z_m,toe_x_m,toe_y_m,toe_z_m,diameter_m,from_m,"
             "to_m,surface_delay_s\n"
             "a,-5,-0.7,10.5,-5,-0.7,-1,0.1,2.5,11.5,0\n"
             "b,-5,0,10.5,-5,0,-1,0.1,2.5,11.5,0\n"
             "c,-5,0.7,10.5,-5,0.7,-1,0.1,2.5,11.5,0\n");
  add_to_scene("\"explosive_density_kg_m3\": 1000");
  BenchRun run = bench_run();
  double moment = 0.0, cubes = 0.0, moved = 0.0;
  for (size_t b = 0; b < run.blocks.size(); ++b) {
    const Vec3& start = run.blocks[b].centroid;
    const bool low = start.z() < 0.5 * kBenchHeight;  // of the rock between them, half stays
    if (std::abs(start.y()) > 0.5 || low) run.last.states[b].centre = start;
    if (std::abs(start.y()) > 0.5 || start.z() < 0.0 || start.x() < -kBurden) continue;
    const double way = run.last.states[b].centre.x() - start.x();
    moment += way, ++cubes;
    if (!low) ++moved;
  }
  write_snapshot(folder().dump("blocks_000002000.csv"), run.blocks, run.last);
  report_rows(folder(), measure_);
  EXPECT_NEAR(summary()["end_holes_throw_m"], 0.0, 1e-6);
  EXPECT_NEAR(summary()["inner_holes_throw_m"], moment / cubes, 1e-6);
  EXPECT_NEAR(summary()["end_to_inner_throw"], 0.0, 1e-6);
  EXPECT_NEAR(summary()["end_holes_moved_fraction"], 0.0, 1e-9);
  EXPECT_NEAR(summary()["inner_holes_moved_fraction"], moved / cubes, 1e-9);
}

}  // namespace
}  // namespace muckpile
