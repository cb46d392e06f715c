// SPDX-License-Identifier: GPL-2.0-or-later
// Movement of the parts of a bench, against means worked by hand.
// Scope: measure/movement and the sub-command on made-up benches.
#include <gtest/gtest.h>

#include <cmath>

#include "args/csv_table.h"
#include "args/input_error.h"
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
  const auto parts = movement_of(rock.blocks, rock.last, {1, 1, 0, 1, 1}, rock.parts);
  ASSERT_EQ(parts.size(), 2U);  // parts without a block are left out
  EXPECT_EQ(parts[0].level, 0);
  EXPECT_EQ(parts[0].distance, 0);
  EXPECT_NEAR((parts[0].displacement() - Vec3(4.0, 0.0, 0.0)).norm(), 0.0, 1e-12);
  EXPECT_DOUBLE_EQ(parts[0].spread, 0.0);
  EXPECT_EQ(parts[1].level, 1);
  EXPECT_EQ(parts[1].distance, 1);
  EXPECT_EQ(parts[1].blocks, 2);
  EXPECT_DOUBLE_EQ(parts[1].level_low, 1.0);
  EXPECT_DOUBLE_EQ(parts[1].far, 2.0);
  EXPECT_NEAR(parts[1].mass, 0.25 * kDensity, 1e-9);
  EXPECT_NEAR(parts[1].moved, 0.5, 1e-12);
  EXPECT_NEAR((parts[1].start - Vec3(-1.5, 0.25, 1.5)).norm(), 0.0, 1e-12);
  EXPECT_NEAR((parts[1].displacement() - Vec3(8.0, 0.0, -1.0)).norm(), 0.0, 1e-12);
  EXPECT_NEAR(parts[1].spread, std::sqrt(5.0), 1e-12);  // each is off by (2, 1, 0)
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
  report_movement(folder, {kCube, 0.125}, {3, 2});
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

TEST(Movement, OfACraterIsRefused) {
  TemporaryFolder temporary;
  write_crater(temporary.path());
  EXPECT_THROW(report_movement(ResultFolder(temporary.path()), {}, {}), InputError);
}

}  // namespace
}  // namespace muckpile
