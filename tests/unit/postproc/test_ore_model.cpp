// SPDX-License-Identifier: GPL-2.0-or-later
// Ore in mine coordinates carried into the pile: block models, polygons and their drawings.
// Scope: made-up runs of cubes.
#include <gtest/gtest.h>

#include <numbers>

#include "args/csv_table.h"
#include "input_error_of.h"
#include "measure/block_finder.h"
#include "report/reports.h"
#include "synthetic_run.h"

namespace muckpile {
namespace {

using namespace testing;

TEST(BlockFinder, FindsTheBlockThatAPointLiesIn) {
  const auto blocks = as_start_blocks(cubes_in({-2, 0, 0}, {0, 2, 1}));
  const BlockFinder finder(blocks);
  for (size_t b = 0; b < blocks.size(); ++b) {
    EXPECT_EQ(finder.at(blocks[b].centroid), b);
    EXPECT_EQ(finder.at(blocks[b].centroid + Vec3(0.249, -0.249, 0.249)), b);
  }
  EXPECT_FALSE(finder.at({0.01, 1.0, 0.5}));
  EXPECT_FALSE(finder.at({-1.0, 1.0, 1.01}));
}

class OreModel : public ::testing::Test {
 protected:
  void SetUp() override { write_bench(temporary_.path()); }
  [[nodiscard]] ResultFolder folder() const { return ResultFolder(temporary_.path()); }
  [[nodiscard]] std::string file(const std::string& text) const {
    return write_text(temporary_.path() / "ore.csv", text);
  }
  TemporaryFolder temporary_;
};

// The bench's own last snapshot tells where the cube about (-0.25, 0.25, 0.25) went.
TEST_F(OreModel, CellsGoWithTheirBlocks) {
  MovementOptions options;
  options.model = file("name,x_m,y_m,z_m,grade\nore,-0.2,0.25,0.25,3.1\nair,5,0,0,0\n");
  report_movement(folder(), {kCube, 0.125}, options);
  const auto blocks = folder().blocks();
  const Snapshot last = read_snapshot(folder().snapshots().back(), blocks);
  const size_t b = *BlockFinder(blocks).at({-0.2, 0.25, 0.25});
  const Vec3 end = moved_point(blocks[b], last.states[b], {-0.2, 0.25, 0.25});
  const CsvTable table = CsvTable::read(folder().file("model_moved.csv"));
  ASSERT_EQ(table.rows(), 2U);
  EXPECT_EQ(table.word(0, 0), "ore");
  EXPECT_EQ(table.word(0, table.column("grade")), "3.1");
  EXPECT_NEAR(table.number(0, table.column("end_x_m")), end.x(), 6e-4);
  EXPECT_NEAR(table.number(0, table.column("moved_m")), (end - Vec3(-0.2, 0.25, 0.25)).norm(),
              1e-4);
  EXPECT_EQ(table.whole(0, table.column("block")), blocks[b].id);
  EXPECT_EQ(table.whole(0, table.column("broken_out")), 1);
  EXPECT_EQ(table.word(1, table.column("end_x_m")), "");
  EXPECT_EQ(read_json_object(folder().file("summary.json"))["model_cells_in_blocks"], 1);
  report_movement(folder(), {kCube, 0.125}, {});
  EXPECT_FALSE(std::filesystem::exists(folder().file("model_moved.csv")));
  EXPECT_FALSE(read_json_object(folder().file("summary.json")).contains("model_cells"));
}

// In the mine north is the throw: (x, y) of the run = (north, -east) after the shift.
TEST_F(OreModel, IsReadAndToldInMineCoordinates) {
  MovementOptions plain, mine;
  plain.model = file("x_m,y_m,z_m\n-0.2,0.25,0.25\n");
  report_movement(folder(), {kCube, 0.125}, plain);
  const CsvTable run = CsvTable::read(folder().file("model_moved.csv"));
  mine.model = file("x_m,y_m,z_m\n354999.75,6199999.8,412.25\n");
  mine.shift = {-355000.0, -6200000.0, -412.0};
  mine.turn_deg = -90.0;
  report_movement(folder(), {kCube, 0.125}, mine);
  const CsvTable table = CsvTable::read(folder().file("model_moved.csv"));
  const auto at = [](const CsvTable& t, const char* name) { return t.number(0, t.column(name)); };
  EXPECT_EQ(at(table, "block"), at(run, "block"));
  EXPECT_NEAR(at(table, "end_x_m") - 355000.0, -at(run, "end_y_m"), 2e-3);
  EXPECT_NEAR(at(table, "end_y_m") - 6200000.0, at(run, "end_x_m"), 2e-3);
  EXPECT_NEAR(at(table, "end_z_m") - 412.0, at(run, "end_z_m"), 2e-3);
  const std::string drawing = text_of(folder().file("movement.dxf"));
  EXPECT_NE(drawing.find("8\nlevel_5\n10\n35"), std::string::npos) << drawing.substr(0, 300);
}

TEST_F(OreModel, OutlinesOfPolygonsAreDrawnInMineCoordinates) {
  MovementOptions mine;
  mine.polygons = file(
      "polygon,x_m,y_m,z_low_m,z_high_m\nall,995,-2,412,432\nall,1000,-2,412,432\n"
      "all,1000,2,412,432\nall,995,2,412,432\n");
  mine.shift = {-1000.0, 0.0, -412.0};
  report_movement(folder(), {kCube, 0.125}, mine);
  const double moved = 507.5 / 105.0 + 2.5;  // the throw of the whole prism
  const CsvTable outline = CsvTable::read(folder().file("polygons_moved.csv"));
  EXPECT_NEAR(outline.number(0, 1), 995.0 + moved, 1e-3);
  const std::string drawing = text_of(folder().file("polygons.dxf"));
  EXPECT_NE(drawing.find("8\nall_before\n10\n995\n20\n-2\n30\n417.25\n"), std::string::npos);
  EXPECT_NE(drawing.find("8\nall_after\n10\n1002.33333"), std::string::npos) << drawing;
}

TEST_F(OreModel, FarFromTheRunIsRefused) {
  MovementOptions options;
  options.model = file("x_m,y_m,z_m\n900,0,0\n");
  EXPECT_NE(input_error_of([&] {
              report_movement(folder(), {kCube, 0.125}, options);
            }).find("no cell's middle lies in a block of the run; see --shift and --turn"),
            std::string::npos);
  options.model = file("x_m,y_m\n0,0\n");
  EXPECT_THROW(report_movement(folder(), {kCube, 0.125}, options), InputError);
}

}  // namespace
}  // namespace muckpile
