// SPDX-License-Identifier: GPL-2.0-or-later
// Dig lines: what digging within polygons of the pile takes out, by ore polygons and block models.
// Scope: cubes by hand, and the made-up bench, whose pile is known cube by cube.
#include <gtest/gtest.h>

#include <cmath>

#include "args/csv_table.h"
#include "input_error_of.h"
#include "measure/dig_line.h"
#include "measure/ore_shares.h"
#include "report/reports.h"
#include "sweep/overlay.h"
#include "synthetic_run.h"

namespace muckpile {
namespace {

using namespace testing;

constexpr double kCubeMass = 0.125 * kDensity;  // [kg]

// Four cubes in a row: ore, half ore, waste, and ore that was not broken out.
TEST(DigLine, CountsBrokenRockByItsCentroid) {
  const auto blocks = as_start_blocks(
      {cube_at({0, 0, 0}), cube_at({1, 0, 0}), cube_at({2, 0, 0}), cube_at({3, 0, 0})});
  const Snapshot last = start_snapshot(blocks);
  const OrePolygon wide{"wide", {{-1, -1}, {5, -1}, {5, 2}, {-1, 2}}, 0.0, 1.0},
      left{"left", {{-1, -1}, {1, -1}, {1, 2}, {-1, 2}}, 0.0, 1.0},
      high{"high", {{-1, -1}, {5, -1}, {5, 2}, {-1, 2}}, 1.0, 2.0};
  const std::vector<char> moved{1, 1, 1, 0};
  const std::vector<double> ore{1.0, 0.5, 0.0, 1.0};
  const DigResult both = dig({wide, left, high}, blocks, last, moved, ore);
  EXPECT_NEAR(both.of_polygon[0].rock, 3.0 * kCubeMass, 1e-9);
  EXPECT_NEAR(both.of_polygon[0].dilution(), 0.5, 1e-12);
  EXPECT_NEAR(both.of_polygon[1].ore, kCubeMass, 1e-9);
  EXPECT_EQ(both.of_polygon[2].rock, 0.0);
  EXPECT_NEAR(both.all.rock, 3.0 * kCubeMass, 1e-9);  // once, though in two polygons
  EXPECT_NEAR(both.ore, 2.5 * kCubeMass, 1e-9);
  EXPECT_NEAR(both.ore_unbroken, kCubeMass, 1e-9);
  EXPECT_NEAR(both.loss_share(), 1.0 / 2.5, 1e-12);
  EXPECT_NEAR(dig({left}, blocks, last, moved, ore).loss_share(), 1.5 / 2.5, 1e-12);
}

// Cells of 1 m, and of 0.25 m, of which a cube has eight.
TEST(OreShares, AreThoseOfTheCellsInABlockOrAroundIt) {
  const auto blocks = as_start_blocks({cube_at({0, 0, 0}), cube_at({0.5, 0, 0})});
  EXPECT_EQ(ore_of_cells({{{0.4, 0.4, 0.4}, true}, {{1.4, 0.4, 0.4}, false}}, {}, blocks),
            (std::vector<double>{1.0, 1.0}));
  std::vector<OreCell> fine;
  for (int k = 0; k < 8; ++k)
    fine.push_back(
        {{0.125 + 0.25 * (k & 1), 0.125 + 0.25 * (k >> 1 & 1), 0.125 + 0.25 * (k >> 2)}, k < 2});
  EXPECT_EQ(ore_of_cells(fine, {}, blocks), (std::vector<double>{0.25, 0.0}));
}

class DigOfABench : public ::testing::Test {
 protected:
  void SetUp() override {
    write_bench(temporary_.path());
    options_.polygons = file("ore.csv", box("north", -5, 0, 0, 2, "0,20"));
  }
  [[nodiscard]] ResultFolder folder() const { return ResultFolder(temporary_.path()); }
  [[nodiscard]] std::string file(const std::string& name, const std::string& rows) const {
    return write_text(temporary_.path() / name, "polygon,x_m,y_m,z_low_m,z_high_m\n" + rows);
  }
  static std::string box(const std::string& name, int x, int to_x, int y, int to_y,
                         const std::string& levels) {
    std::string rows;
    for (const auto& [a, b] : {std::pair(x, y), {to_x, y}, {to_x, to_y}, {x, to_y}})
      rows += name + "," + std::to_string(a) + "," + std::to_string(b) + "," + levels + "\n";
    return rows;
  }
  [[nodiscard]] CsvTable dug() const {
    report_movement(folder(), {kCube, 0.125}, options_);
    return CsvTable::read(folder().file("dig.csv"));
  }
  [[nodiscard]] std::string error() const {
    return input_error_of([&] { report_movement(folder(), {kCube, 0.125}, options_); });
  }
  TemporaryFolder temporary_;
  MovementOptions options_;
};

// Ore is the half of the prism at y > 0, 420 cubes. Within 7 m of the toe lie 154 cubes of each of
// the four rows; the lowest layer has 28 of each.
TEST_F(DigOfABench, HasTheTonnesOfItsLevels) {
  options_.dig =
      file("lines.csv", box("near", 0, 7, -2, 2, "-1,20") + box("floor", 0, 20, -2, 2, "0,0.6"));
  const CsvTable table = dug();
  const auto at = [&](size_t row, const char* column) {
    return table.number(row, table.column(column));
  };
  const double cube = kCubeMass / 1000.0;
  ASSERT_EQ(table.rows(), 3U);
  EXPECT_NEAR(at(0, "dug_t"), 4 * 154 * cube, 1e-3);
  EXPECT_NEAR(at(0, "dilution_fraction"), 0.5, 1e-6);
  EXPECT_NEAR(at(0, "ore_recovered_fraction"), 154.0 / 210.0, 1e-5);
  EXPECT_NEAR(at(1, "ore_t"), 2 * 28 * cube, 1e-3);
  EXPECT_EQ(at(1, "z_high_m"), 0.6);
  EXPECT_EQ(table.word(0, table.column("ore_loss_t")), "");
  // Both together: 14 cubes of each row lie on the floor beyond 7 m.
  EXPECT_EQ(table.word(2, 0), "all");
  EXPECT_NEAR(at(2, "dug_t"), 4 * (154 + 14) * cube, 1e-3);
  EXPECT_NEAR(at(2, "ore_loss_t"), 2 * (210 - 168) * cube, 1e-3);
  EXPECT_NEAR(at(2, "ore_loss_fraction"), 0.2, 1e-6);
  const auto keys = read_json_object(folder().file("summary.json"));
  EXPECT_NEAR(keys["dig_ore_loss_fraction"].get<double>(), 0.2, 1e-9);
  EXPECT_NEAR(keys["dig_ore_before_t"].get<double>(), 420 * cube, 1e-6);
  EXPECT_GT(std::filesystem::file_size(folder().file("dig.png")), 1000U);
  options_.dig.clear();
  report_movement(folder(), {kCube, 0.125}, options_);
  EXPECT_FALSE(std::filesystem::exists(folder().file("dig.csv")));
  EXPECT_FALSE(read_json_object(folder().file("summary.json")).contains("dig_ore_t"));
}

// The same ore by the grades of cells of 1 m, in a mine whose x is 1000 m more.
TEST_F(DigOfABench, TakesOreFromABlockModelInMineCoordinates) {
  std::string cells = "x_m,y_m,z_m,grade\n";
  for (int x = 0; x < 5; ++x)
    for (int z = 0; z < 11; ++z)
      for (const char* row : {"-0.4", "0.6"})
        cells += std::to_string(995.4 + x) + "," + row + "," + std::to_string(0.4 + z) +
                 (row[0] == '-' ? ",0.2\n" : ",1.5\n");
  options_ = {};
  options_.model = write_text(temporary_.path() / "model.csv", cells);
  options_.ore_column = "grade";
  options_.cutoff = 1.5;
  options_.shift = {-1000.0, 0.0, 0.0};
  options_.dig = file("lines.csv", box("near", 1000, 1007, -2, 2, "-1,20"));
  const CsvTable table = dug();
  EXPECT_NEAR(table.number(1, table.column("dilution_fraction")), 0.5, 1e-6);
  EXPECT_NEAR(table.number(1, table.column("ore_loss_fraction")), 56.0 / 210.0, 1e-5);
}

TEST_F(DigOfABench, OverlaysWithThatOfAnotherRun) {
  options_.dig = file("lines.csv", box("near", 0, 7, -2, 2, "-1,20"));
  (void)dug();
  write_text(temporary_.path() / "other.csv",
             "polygon,z_low_m,z_high_m,dug_t,ore_t,waste_t,dilution_fraction,"
             "ore_recovered_fraction,ore_loss_t,ore_loss_fraction\nall,,,9,9,0,0.3,1,0,0\n");
  const OverlaidRows rows = overlaid_rows(
      {folder().file("dig.csv"), temporary_.path() / "other.csv"}, {"dilution_fraction"});
  ASSERT_EQ(rows.rows.size(), 2U);  // near, and all
  EXPECT_EQ(rows.rows[1].names, std::vector<std::string>{"all"});
  EXPECT_NEAR(rows.rows[1].spread.mean, 0.4, 1e-6);
}

TEST_F(DigOfABench, RefusesLinesWhereItsResultGoes) {
  options_.dig = file("dig.csv", box("near", 0, 7, -2, 2, "-1,20"));
  EXPECT_NE(error().find("dig.csv, where the result goes"), std::string::npos);
  EXPECT_TRUE(std::filesystem::exists(options_.dig));
}

TEST_F(DigOfABench, RefusesWhatHasNoOre) {
  options_.dig = file("lines.csv", box("near", 0, 7, -2, 2, "-1,20"));
  options_.polygons.clear();
  EXPECT_NE(error().find("movement: --dig: needs ore: --polygons, or --model"), std::string::npos);
  options_.ore_column = "grade";
  EXPECT_NE(error().find("movement: --ore-column: needs --model"), std::string::npos);
  options_.model = write_text(temporary_.path() / "model.csv", "x_m,y_m,z_m,au\n-1,0.2,1.2,3\n");
  EXPECT_NE(error().find("grade"), std::string::npos);
  options_.ore_column = "au";
  options_.cutoff = 4.0;
  EXPECT_NE(error().find("no block of the run is ore"), std::string::npos);
}

// As lines of another place, or in other coordinates.
TEST_F(DigOfABench, RefusesLinesWithoutRock) {
  options_.dig = file("lines.csv", box("far", 400, 500, -2, 2, "-1,20"));
  EXPECT_NE(error().find("lines.csv: no rock lies in its polygons after the blast"),
            std::string::npos);
}

}  // namespace
}  // namespace muckpile
