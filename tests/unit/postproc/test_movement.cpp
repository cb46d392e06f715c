// SPDX-License-Identifier: GPL-2.0-or-later
// Movement of the parts of a bench, against means worked by hand.
// Scope: measure/movement and the sub-command on made-up benches.
#include <gtest/gtest.h>

#include <cmath>

#include "args/csv_table.h"
#include "args/input_error.h"
#include "input_error_of.h"
#include "io/ore_polygons.h"
#include "measure/dug_polygon.h"
#include "measure/movement.h"
#include "report/reports.h"
#include "synthetic_run.h"

namespace muckpile {
namespace {

using namespace testing;

// Two levels of 1 m by two distances of 1 m: one cube in the lower near part, two in the upper far
// one, one behind the last row and one below the floor.
struct FiveCubes {
  std::vector<StartBlock> blocks =
      as_start_blocks({cube_at({-0.5, 0, 0}), cube_at({-1.5, 0, 1}), cube_at({-2, 0, 1.5}),
                       cube_at({-3, 0, 1}), cube_at({-0.5, 0, -0.5})});
  Snapshot last = start_snapshot(blocks);
  BenchParts parts{2.0, 2.0, 2, 2};
};

TEST(Movement, IsTheMeanOverTheBlocksOfAPart) {
  FiveCubes rock;
  rock.last.states[0].centre += Vec3(4.0, 0.0, 0.0);
  rock.last.states[1].centre += Vec3(6.0, 1.0, -1.0);
  rock.last.states[2].centre += Vec3(10.0, -1.0, -1.0);
  rock.last.states[3].centre += Vec3(50.0, 0.0, 0.0);
  const auto parts = movement_of_parts(rock.blocks, rock.last, {1, 1, 0, 1, 1}, rock.parts);
  ASSERT_EQ(parts.size(), 2U);  // parts without a block are left out
  EXPECT_EQ(parts[0].level, 0);
  EXPECT_EQ(parts[0].distance, 0);
  EXPECT_NEAR((parts[0].rock.displacement() - Vec3(4.0, 0.0, 0.0)).norm(), 0.0, 1e-12);
  EXPECT_DOUBLE_EQ(parts[0].rock.spread, 0.0);
  EXPECT_EQ(parts[1].level, 1);
  EXPECT_EQ(parts[1].distance, 1);
  EXPECT_EQ(parts[1].rock.blocks, 2);
  EXPECT_DOUBLE_EQ(parts[1].level_low, 1.0);
  EXPECT_DOUBLE_EQ(parts[1].far, 2.0);
  EXPECT_NEAR(parts[1].rock.mass, 0.25 * kDensity, 1e-9);
  EXPECT_NEAR(parts[1].rock.moved, 0.5, 1e-12);
  EXPECT_NEAR((parts[1].rock.start - Vec3(-1.5, 0.25, 1.5)).norm(), 0.0, 1e-12);
  EXPECT_NEAR((parts[1].rock.displacement() - Vec3(8.0, 0.0, -1.0)).norm(), 0.0, 1e-12);
  EXPECT_NEAR(parts[1].rock.spread, std::sqrt(5.0), 1e-12);  // each is off by (2, 1, 0)
}

TEST(Movement, BlocksOutsideHaveNoLevel) {
  const FiveCubes rock;
  EXPECT_EQ(levels_of(rock.blocks, rock.parts), (std::vector<int>{0, 1, 1, -1, -1}));
}

// All of the prism is in the parts; the mass centre of all of them moves as the prism's.
TEST(Movement, OfAllPartsIsTheThrowOfTheBurden) {
  TemporaryFolder temporary;
  write_bench(temporary.path());
  const ResultFolder folder(temporary.path());
  MovementOptions options;
  options.levels = 3;
  options.distances = 2;
  report_movement(folder, {kCube, 0.125}, options);
  const CsvTable table = CsvTable::read(folder.file("movement.csv"));
  ASSERT_EQ(table.rows(), 6U);
  double mass = 0.0, moment = 0.0;
  for (size_t row = 0; row < table.rows(); ++row) {
    const double part = table.number(row, table.column("mass_kg"));
    mass += part;
    moment += part * table.number(row, table.column("moved_x_m"));
    EXPECT_EQ(table.number(row, table.column("broken_out_fraction")), 1.0);
  }
  EXPECT_NEAR(moment / mass, 507.5 / 105.0 + 2.5, 1e-4);  // six digits in the table
  EXPECT_NEAR(mass, 5.0 * 10.5 * 2.0 * kDensity, 1.0);
  EXPECT_TRUE(std::filesystem::exists(folder.file("movement.png")));
  EXPECT_EQ(read_json_object(folder.file("summary.json"))["movement_parts"], 6);
}

// A square of 1 m: one cube in it goes 10 m far and one 12 m, so the outline goes 11 m, with both
// within it; a strange cube lies beside them.
TEST(DugPolygon, MovesAsItsRockAndTellsTheDilution) {
  const auto blocks =
      as_start_blocks({cube_at({0, 0, 0}), cube_at({0.5, 0.5, 0}), cube_at({-3, 0, 0})});
  Snapshot last = start_snapshot(blocks);
  last.states[0].centre = Vec3(10.25, 0.25, 0.0);
  last.states[1].centre = Vec3(12.75, 0.75, 0.0);
  last.states[2].centre = Vec3(11.5, 0.5, 0.0);
  const OrePolygon square{"A", {{0, 0}, {1, 0}, {1, 1}, {0, 1}}, -1.0, 1.0};
  const DugPolygon dug = dug_polygon(square, {0, 1}, blocks, last, {1, 1, 1});
  EXPECT_NEAR((dug.outline[0] - Vec2(11.0, 0.0)).norm(), 0.0, 1e-12);  // by 10 and 12 m
  EXPECT_NEAR(dug.recovered, 0.0, 1e-12);  // at 10.25 and 12.75, beside 11 to 12
  EXPECT_NEAR(dug.dilution, 1.0, 1e-12);
  last.states[0].centre.x() = 11.25;
  last.states[1].centre.x() = 11.75;  // the outline from 11 to 12 again
  const DugPolygon whole = dug_polygon(square, {0, 1}, blocks, last, {1, 1, 1});
  EXPECT_NEAR(whole.recovered, 1.0, 1e-12);
  EXPECT_NEAR(whole.dilution, 1.0 / 3.0, 1e-12);
  EXPECT_NEAR(dug_polygon(square, {0, 1}, blocks, last, {1, 1, 0}).dilution, 0.0, 1e-12);
}

class Polygons : public ::testing::Test {
 protected:
  [[nodiscard]] std::filesystem::path file(const std::string& rows) const {
    write_text(temporary_.path() / "ore.csv", rows);
    return temporary_.path() / "ore.csv";
  }
  void expect_refused(const std::string& rows, const std::string& part) const {
    try {
      (void)read_ore_polygons(file(rows));
      FAIL() << "read";
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    }
  }
  TemporaryFolder temporary_;
};

TEST_F(Polygons, AreReadCornerByCorner) {
  const auto polygons =
      read_ore_polygons(file("polygon,x_m,y_m,z_low_m,z_high_m\nA,0,0,1,2\nA,1,0,1,2\nA,0,1,1,2\n"
                             "B,0,0,0,9\nB,-1,0,0,9\nB,0,1,0,9\n"));
  ASSERT_EQ(polygons.size(), 2U);
  EXPECT_EQ(polygons[1].name, "B");
  EXPECT_TRUE(polygons[0].contains(Vec3(0.2, 0.2, 1.5)));
  EXPECT_FALSE(polygons[0].contains(Vec3(0.2, 0.2, 2.5)));
  EXPECT_FALSE(polygons[0].contains(Vec3(0.8, 0.8, 1.5)));
  EXPECT_TRUE(polygons[1].contains(Vec3(-0.2, 0.2, 1.5)));
}

TEST_F(Polygons, FaultyOnesAreRefusedByLine) {
  const std::string head = "polygon,x_m,y_m\n";
  expect_refused(head, "has no row");
  expect_refused(head + "A,0,0\nA,1,0\n", "ore.csv:3: polygon 'A' must have three corners");
  expect_refused(head + "A,0,0\nA,1,0\nA,2,0\n", "polygon 'A' has no area");
  expect_refused(head + "A,0,0\nA,4,4\nA,4,0\nA,0,3\n",
                 "ore.csv:5: polygon 'A' crosses itself: its edge from corner 1 to 2 and that from "
                 "corner 3 to 4; give the corners in order");
  expect_refused(head + "A,0,0\nA,1,0\nA,0,1\nB,0,0\nB,1,0\nB,0,1\nA,3,3\n",
                 "ore.csv:8: the rows of polygon 'A' must follow each other");
  expect_refused(head + "A,0,x\n", "ore.csv:2");
  expect_refused("polygon,x_m,y_m,z_low_m\nA,0,0,0\n", "must both be there, or neither");
  expect_refused("polygon,x_m,y_m,z_low_m,z_high_m\nA,0,0,2,1\n", "z_high_m must be > z_low_m");
  expect_refused("polygon,x_m,y_m,z_low_m,z_high_m\nA,0,0,0,1\nA,0,0,0,2\n", "must be the same");
}

// A ring around an island, whose corners come twice where it is cut open, and a corner on an edge.
TEST_F(Polygons, MayTouchThemselves) {
  const auto ring = read_ore_polygons(
      file("polygon,x_m,y_m\nA,0.1,0.3\nA,9.1,0.3\nA,9.1,9.3\nA,0.1,9.3\nA,0.1,0.3\n"
           "A,3.1,3.3\nA,3.1,6.3\nA,6.1,6.3\nA,6.1,3.3\nA,3.1,3.3\n"));
  EXPECT_TRUE(ring[0].contains(Vec3(1, 5, 0)));
  EXPECT_FALSE(ring[0].contains(Vec3(5, 5, 0)));
  EXPECT_EQ(read_ore_polygons(file("polygon,x_m,y_m\nA,0,0\nA,2,0\nA,2,2\nA,1,0\nA,0,2\n")).size(),
            1U);
  // In mine coordinates of two decimals, a corner at the middle of another edge is on it.
  EXPECT_EQ(
      read_ore_polygons(file("polygon,x_m,y_m\nA,600022.01,7100093.25\nA,600041.35,7100111.67\n"
                             "A,600022.47,7100112.13\nA,600031.68,7100102.46\n"
                             "A,600019.24,7100109.06\n"))
          .size(),
      1U);
}

// The whole prism in one polygon: it goes as far as the throw.
TEST_F(Polygons, AreCarriedIntoThePile) {
  write_bench(temporary_.path());
  const ResultFolder folder(temporary_.path());
  MovementOptions options;
  options.polygons = file(
                         "polygon,x_m,y_m,z_low_m,z_high_m\nall,-5,-2,0,20\nall,0,-2,0,20\n"
                         "all,0,2,0,20\nall,-5,2,0,20\n")
                         .string();
  report_movement(folder, {kCube, 0.125}, options);
  const CsvTable table = CsvTable::read(folder.file("polygons.csv"));
  ASSERT_EQ(table.rows(), 1U);
  EXPECT_EQ(table.word(0, table.column("polygon")), "all");
  EXPECT_NEAR(table.number(0, table.column("moved_x_m")), 507.5 / 105.0 + 2.5, 1e-4);
  EXPECT_EQ(table.number(0, table.column("dilution_fraction")), 0.0);
  const CsvTable outline = CsvTable::read(folder.file("polygons_moved.csv"));
  EXPECT_NEAR(outline.number(0, 1), 507.5 / 105.0 - 2.5, 6e-4);  // millimetres
  EXPECT_TRUE(std::filesystem::exists(folder.file("polygons.png")));
  options.polygons = file("polygon,x_m,y_m\nfar,50,0\nfar,51,0\nfar,50,1\n").string();
  EXPECT_EQ(input_error_of([&] {
              report_movement(folder, {kCube, 0.125}, options);
            }),
            options.polygons +
                ": no block's centroid started in polygon 'far'; see its place (--shift, --turn, "
                "--mine) and heights");
  report_movement(folder, {kCube, 0.125}, {});
  EXPECT_FALSE(std::filesystem::exists(folder.file("polygons.csv")));
}

TEST(Movement, OfACraterIsRefused) {
  TemporaryFolder temporary;
  write_crater(temporary.path());
  EXPECT_THROW(report_movement(ResultFolder(temporary.path()), {}, {}), InputError);
}

}  // namespace
}  // namespace muckpile
