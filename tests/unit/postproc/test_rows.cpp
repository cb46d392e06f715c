// SPDX-License-Identifier: GPL-2.0-or-later
// The rock of holes and rows, heights over the plan, backbreak and toe left, by hand.
// Scope: measure/hole_rock, measure/height_map, and the reports rows, heights and plan on the
// made-up bench.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>

#include "args/input_error.h"
#include "geometry/files/block_file.h"
#include "input_error_of.h"
#include "measure/height_map.h"
#include "measure/hole_polygons.h"
#include "measure/hole_rock.h"
#include "report/all_reports.h"
#include "report/not_measurable.h"
#include "report/plan_report.h"
#include "report/reports.h"
#include "synthetic_run.h"

namespace muckpile {
namespace {

using namespace testing;

// Two holes 5 m behind the face, one 2.6 m behind them.
constexpr const char* kTable =
    "hole,collar_x_m,collar_y_m,collar_z_m,toe_x_m,toe_y_m,toe_z_m,diameter_m,from_m,to_m,"
    "surface_delay_s\n"
    "back,-7.6,0,10.5,-7.6,0,-1,0.1,2.5,11.5,0.042\n"
    "left,-5,-0.5,10.5,-5,-0.5,-1,0.1,2.5,11.5,0\n"
    "right,-5,0.5,10.5,-5,0.5,-1,0.1,2.5,11.5,0.005\n";

HoleTable table(const std::string& text) { return HoleTable(CsvTable::parse(text, "t.csv")); }

TEST(PatternHoles, AreNumberedByRowFromTheFaceAndAlongIt) {
  const auto holes = pattern_holes(table(kTable), {1.0, 2.0, 4.0}, 5.0);
  ASSERT_EQ(holes.size(), 3U);
  EXPECT_EQ(holes[0].name, "left");
  EXPECT_EQ(holes[1].name, "right");
  EXPECT_EQ(holes[2].name, "back");
  EXPECT_EQ(holes[1].row, 0);
  EXPECT_EQ(holes[2].row, 1);
  EXPECT_EQ(holes[2].charge, 1.0);
}

TEST(PatternHoles, DecksOfOneHoleAreTogetherAndLeaningOnesStandAtTheFloor) {
  // A metre back per 4 m of height: at z = 0 half a metre behind the toe.
  const auto holes =
      pattern_holes(table("hole,collar_x_m,collar_y_m,collar_z_m,toe_x_m,toe_y_m,toe_z_m,"
                          "diameter_m,from_m,to_m,in_hole_delay_s\n"
                          "a,-6,1,10,-3,1,-2,0.1,6,9,0.025\na,-6,1,10,-3,1,-2,0.1,2,5,0.01\n"),
                    {3.0, 4.0}, 3.0);
  ASSERT_EQ(holes.size(), 1U);
  EXPECT_NEAR(holes[0].foot.x(), -3.5, 1e-12);
  EXPECT_NEAR(holes[0].lean.x(), -0.25, 1e-12);
  EXPECT_EQ(holes[0].charge, 7.0);
  EXPECT_EQ(holes[0].firing_time, 0.01);
}

TEST(HoleOfBlocks, IsTheFirstBehindTheBlockAtItsHeight) {
  // One hole leans back by a metre per metre from x = -1, the other stands at x = -4: their rock
  // meets at the axis of the first.
  const auto holes =
      pattern_holes(table("hole,collar_x_m,collar_y_m,collar_z_m,toe_x_m,toe_y_m,toe_z_m,"
                          "diameter_m\n"
                          "a,-4,0,3,-1,0,0,0.1\nb,-4,0,3,-4,0,0,0.1\n"),
                    {1.0, 1.0}, 2.0);
  const auto blocks = as_start_blocks(cubes_in({-5.0, 0.0, -0.5}, {0.0, 0.5, 3.0}));
  const std::vector<int> owner = hole_of_blocks(blocks, holes, {});
  for (size_t b = 0; b < blocks.size(); ++b) {
    const Vec3& c = blocks[b].centroid;
    const int expected = c.z() < 0.0          ? -1  // below the floor
                         : c.x() < -4.0       ? -1  // behind the last row
                         : c.x() > -1 - c.z() ? 0
                                              : 1;
    if (c.x() == -1 - c.z()) continue;  // on the border
    EXPECT_EQ(owner[b], expected) << c.transpose();
  }
}

// Of two holes of a row a metre apart along the throw each has its own line; the hole behind has
// what lies behind both.
TEST(HoleOfBlocks, FollowsRowsThatAreNotStraight) {
  const auto holes = pattern_holes(
      table("hole,collar_x_m,collar_y_m,collar_z_m,toe_x_m,toe_y_m,toe_z_m,diameter_m\n"
            "left,-2,-1,3,-2,-1,0,0.1\nright,-3,1,3,-3,1,0,0.1\nback,-6,0.3,3,-6,0.3,0,0.1\n"),
      {1.0, 1.0, 1.0}, 3.0);
  const auto blocks = as_start_blocks(cubes_in({-7.0, -2.0, 0.0}, {0.0, 2.0, 0.5}));
  const std::vector<int> owner = hole_of_blocks(blocks, holes, {});
  BenchPlanes planes;
  const auto polygons = hole_polygons(holes, planes, {0.25, {-7.0, -2.0}, {0.0, 2.0}});
  ASSERT_EQ(polygons.size(), 3U);
  EXPECT_NEAR(area_of(polygons[0].corners), 2.0 * 2.0, 1e-12);
  EXPECT_NEAR(area_of(polygons[1].corners), 3.0 * 2.0, 1e-12);
  EXPECT_NEAR(area_of(polygons[2].corners), 4.0 * 2.0 + 3.0 * 2.0, 1e-12);
  for (size_t b = 0; b < blocks.size(); ++b) {
    const Vec3& c = blocks[b].centroid;
    const int expected = c.x() < -6.0   ? -1
                         : c.y() < 0.0  ? (c.x() > -2.0 ? 0 : 2)
                         : c.x() > -3.0 ? 1
                                        : 2;
    EXPECT_EQ(owner[b], expected) << c.transpose();
  }
}

TEST(Backbreak, IsTheFarthestLooseBlockBehindTheLastRowInEachSection) {
  const auto blocks = as_start_blocks(cubes_in({-4.0, -1.0, -0.5}, {0.0, 1.0, 1.0}));
  Snapshot last = start_snapshot(blocks);
  const auto push = [&](const Vec3& where, double way) {
    for (size_t b = 0; b < blocks.size(); ++b)
      if ((blocks[b].centroid - where).norm() < 1e-9) last.states[b].centre.x() += way;
  };
  push({-2.75, 0.25, 0.25}, 0.2);
  push({-3.75, 0.75, 0.25}, 0.05);  // too little
  push({-3.75, 0.75, -0.25}, 0.2);  // below the floor
  push({-1.25, -0.75, 0.25}, 0.2);  // in front of the row
  BenchPlanes planes;
  planes.y_low = -1.0;
  planes.y_high = 1.0;
  const Reach upright = backbreak(blocks, shifted(blocks, last, 0.1), planes, 2.0, 0.5);
  EXPECT_NEAR(upright.largest, 0.75, 1e-12);
  EXPECT_NEAR(upright.mean, 0.75 / 4.0, 1e-12);  // in one of four sections
  planes.hole_back = 0.5;                        // 0.125 m less at this height
  EXPECT_NEAR(backbreak(blocks, shifted(blocks, last, 0.1), planes, 2.0, 0.5).largest, 0.625,
              1e-12);
}

TEST(Backbreak, OfLooseRockCountsBlocksWithMostOfTheirJointsBroken) {
  const auto blocks = as_start_blocks(cubes_in({-1.0, 0.0, 0.0}, {0.0, 0.5, 0.5}));
  Snapshot last = start_snapshot(blocks);
  last.states[0].broken_fraction = 0.6;
  last.states[1].broken_fraction = 0.4;
  EXPECT_EQ(loosened(last), (std::vector<char>{1, 0}));
}

class Rows : public ::testing::Test {
 protected:
  void SetUp() override {
    write_bench(temporary_.path());
    write_text(folder().dump("holes.csv"), kTable);
    std::string scene = text_of(folder().dump("scene.json"));
    write_text(folder().dump("scene.json"), scene.insert(1, "\"explosive_density_kg_m3\": 800, "));
  }
  [[nodiscard]] ResultFolder folder() const { return ResultFolder(temporary_.path()); }
  [[nodiscard]] nlohmann::ordered_json summary() const {
    return read_json_object(folder().file("summary.json"));
  }
  TemporaryFolder temporary_;
  // pi/4 0.1^2 9 m3 of 800 kg/m3
  static constexpr double kCharge = std::numbers::pi * 0.0025 * 9.0 * 800.0;
  static constexpr double kThrow = 507.5 / 105.0 + 2.5;  // of the burden prism
};

TEST_F(Rows, RockOfEachHoleIsItsBurden) {
  report_rows(folder(), {kCube, 0.125});
  const CsvTable rows = CsvTable::read(folder().file("rows.csv"));
  ASSERT_EQ(rows.rows(), 6U);  // three holes, two rows, all
  const auto value = [&](size_t row, const char* name) {
    return rows.number(row, rows.column(name));
  };
  EXPECT_EQ(rows.word(0, 0), "left");
  EXPECT_EQ(rows.word(2, 0), "back");
  EXPECT_EQ(rows.word(3, 0), "row 1");
  // To x = -5: 10 columns of 2 x 21 cubes of 0.125 m3, all thrown.
  for (const size_t hole : {0U, 1U}) {
    EXPECT_EQ(value(hole, "blocks"), 420.0);
    EXPECT_NEAR(value(hole, "volume_m3"), 52.5, 1e-3);
    EXPECT_NEAR(value(hole, "moved_volume_m3"), 52.5, 1e-3);
    EXPECT_NEAR(value(hole, "throw_m"), kThrow, 1e-5);
    EXPECT_NEAR(value(hole, "velocity_m_s"), (2 * 14.0 + 8 * 6.0) / 10.0, 1e-5);
    EXPECT_NEAR(value(hole, "velocity_at_s"), 0.01, 1e-9);
    EXPECT_NEAR(value(hole, "specific_charge_kg_m3"), kCharge / 52.5, 1e-5);
  }
  // On to x = -7.6: five columns of 4 x 21 whose centres lie in front of it.
  EXPECT_EQ(value(2, "blocks"), 420.0);
  EXPECT_EQ(value(2, "throw_m"), 0.0);
  EXPECT_EQ(value(5, "blocks"), 1260.0);
  EXPECT_NEAR(value(5, "throw_m"), kThrow * 840.0 / 1260.0, 1e-5);
  EXPECT_EQ(summary()["rows"], 2);
  EXPECT_NEAR(summary()["blast_charge_kg"], 3.0 * kCharge, 1e-9);
  EXPECT_NEAR(summary()["front_row_throw_m"], kThrow, 1e-6);
  EXPECT_EQ(summary()["last_row_throw_m"], 0.0);
}

TEST_F(Rows, FaceVelocityStandsForEachHoleOfTheFirstRow) {
  report_rows(folder(), {kCube, 0.125});
  const CsvTable face = CsvTable::read(folder().file("face_velocity.csv"));
  ASSERT_EQ(face.rows(), 30U);  // ten bands of all and of two holes
  EXPECT_EQ(face.word(10, 0), "left");
  for (size_t row = 0; row < face.rows(); ++row)
    EXPECT_NEAR(face.number(row, face.column("velocity_m_s")), 14.0, 1e-6);
  EXPECT_TRUE(std::filesystem::exists(folder().file("face_velocity.png")));
}

// To x = -5 each over half the width of the rock, which half a spacing beside them would pass by
// half a metre; behind them to x = -7.6.
TEST_F(Rows, PolygonsAreTheBurdenOfEachHole) {
  report_rows(folder(), {kCube, 0.125});
  const CsvTable table = CsvTable::read(folder().file("hole_polygons.csv"));
  std::map<std::string, std::vector<Vec2>> corners;
  for (size_t row = 0; row < table.rows(); ++row)
    corners[std::string(table.word(row, 0))].emplace_back(table.number(row, 1),
                                                          table.number(row, 2));
  EXPECT_NEAR(area_of(corners["left"]), 5.0, 1e-6);
  EXPECT_NEAR(area_of(corners["right"]), 5.0, 1e-6);
  EXPECT_NEAR(area_of(corners["back"]), 2.6 * 2.0, 1e-6);
  EXPECT_EQ(corners["back"].size(), 4U);
}

TEST_F(Rows, NeedAHoleTable) {
  std::filesystem::remove(folder().dump("holes.csv"));
  EXPECT_THROW(report_rows(folder(), {}), InputError);
  const auto reports = reports_of(folder(), false);
  EXPECT_EQ(std::ranges::count(reports, "rows"), 0);
}

TEST_F(Rows, RefuseTheHoleTableOfAnotherRun) {
  const std::string run = text_of(folder().dump("run.json"));
  const auto back_charge_at = [&](const std::string& x) {
    std::string holes;
    for (const std::string& place : {x + ", 0", std::string("-5, -0.5"), std::string("-5, 0.5")})
      holes += (holes.empty() ? R"({"toe_m": [)" : R"(, {"toe_m": [)") + place +
               R"(, -1], "collar_m": [)" + place + R"(, 8], "radius_m": 0.15})";
    write_text(folder().dump("run.json"),
               std::string(run).insert(1, "\"holes\": [" + holes + "], "));
  };
  const std::string table_file = folder().dump("holes.csv").string(),
                    run_file = folder().dump("run.json").string(),
                    advice = "; give the folder the table that the run has read";
  back_charge_at("-7.6");
  EXPECT_NO_THROW(report_rows(folder(), {}));
  back_charge_at("-6.6");
  EXPECT_EQ(input_error_of([&] { report_rows(folder(), {}); }),
            table_file + ": hole 'back' is not where " + run_file + " has a charge" + advice);
  back_charge_at("-7.6");
  const std::string table = text_of(table_file);
  write_text(table_file, table.substr(0, table.find("right")));
  EXPECT_EQ(input_error_of([&] { report_rows(folder(), {}); }),
            table_file + ": has 2 charges, " + run_file + " 3" + advice);
}

TEST_F(Rows, ArePartOfAllWhereThereIsATable) {
  const auto reports = reports_of(folder(), false);
  EXPECT_EQ(std::ranges::count(reports, "rows"), 1);
  EXPECT_EQ(std::ranges::count(reports, "heights"), 1);
}

TEST_F(Rows, OfARefusedBenchLeaveNoFigures) {
  report_rows(folder(), {});
  std::vector<Block> blocks = bench_run().shapes;
  shear(blocks, 140.0);
  write_blocks(folder().dump("blocks.vtk").string(), blocks, 1, kDensity);
  EXPECT_THROW(report_rows(folder(), {}), NotMeasurable);
  for (const char* file : {"rows.csv", "face_velocity.csv", "face_velocity.png"})
    EXPECT_FALSE(std::filesystem::exists(folder().file(file))) << file;
  EXPECT_FALSE(summary().contains("front_row_throw_m"));
  EXPECT_TRUE(summary().contains("rows_refused"));
}

TEST_F(Rows, HeightsGiveVolumesToeAndTable) {
  report_heights(folder(), {kCube, 0.25});
  const auto keys = summary();
  // To x = -7.6: 15 columns of 4 x 21 cubes of 0.125 m3. 840 cubes were thrown; 5 columns stand.
  EXPECT_NEAR(keys["prism_volume_m3"], 157.5, 1e-6);
  EXPECT_NEAR(keys["moved_volume_m3"], 105.0, 1e-6);
  EXPECT_NEAR(keys["toe_left_volume_m3"], 52.5, 1e-6);
  EXPECT_NEAR(keys["toe_left_height_m"], kBenchHeight, 1e-6);
  EXPECT_NEAR(keys["pile_survey_volume_m3"], 840 * 0.5 * 0.5 * kLayer, 1e-3);
  EXPECT_NEAR(keys["pile_survey_swell"], kLayer / kCube, 1e-5);
  EXPECT_EQ(keys["backbreak_m"], 0.0);
  const CsvTable heights = CsvTable::read(folder().file("heights.csv"));
  const auto at = [&](double x, const char* name) {
    for (size_t row = 0; row < heights.rows(); ++row) {
      if (std::abs(heights.number(row, 0) - x) < 1e-9)
        return heights.number(row, heights.column(name));
    }
    return std::nan("");
  };
  EXPECT_NEAR(at(-6.125, "before_m"), 10.5, 1e-6);
  EXPECT_NEAR(at(-6.125, "rock_in_place_m"), 10.5, 1e-6);
  EXPECT_NEAR(at(0.125, "before_m"), 0.0, 1e-6);
  EXPECT_NEAR(at(0.125, "after_m"), 14 * kLayer, 1e-6);
  EXPECT_NEAR(at(0.125, "rock_in_place_m"), 0.0, 1e-6);
  EXPECT_TRUE(std::filesystem::exists(folder().file("heights.png")));
}

TEST_F(Rows, PlanHasTheChargeWithin8Ms) {
  report_plan(temporary_.path());
  EXPECT_EQ(summary()["most_decks_within_8_ms"], 2);  // 0 and 5 ms; 42 ms is alone
  EXPECT_NEAR(summary()["largest_charge_within_8_ms_kg"], 2.0 * kCharge, 1e-9);
}

}  // namespace
}  // namespace muckpile
