// SPDX-License-Identifier: GPL-2.0-or-later
// Columns through blocks and vertical sections, against shapes whose heights and areas are known.
// Scope: measure/columns, measure/section, measure/scan_polygon.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

#include "measure/columns.h"
#include "measure/section.h"
#include "synthetic_run.h"

namespace muckpile {
namespace {

using namespace testing;

double area_of(const std::vector<Vec2>& p) {
  double twice = 0.0;
  for (size_t i = 0, j = p.size() - 1; i < p.size(); j = i++)
    twice += p[j].x() * p[i].y() - p[i].x() * p[j].y();
  return 0.5 * std::abs(twice);
}

TEST(ScanPolygon, TwoTrianglesOfASquareCoverEachCellOnce) {
  std::vector<int> hits(100, 0);
  std::vector<double> scratch;
  const auto count = [&](int row, int begin, int end) {
    for (int i = begin; i < end; ++i) ++hits[static_cast<size_t>(row * 10 + i)];
  };
  // The diagonal runs through cell centres, where a careless rule counts twice or not at all.
  const Vec2 lower[] = {{0, 0}, {10, 0}, {10, 10}}, upper[] = {{0, 0}, {10, 10}, {0, 10}};
  scan_polygon(lower, 10, 10, scratch, count);
  scan_polygon(upper, 10, 10, scratch, count);
  for (const int n : hits) EXPECT_EQ(n, 1);
}

TEST(Columns, UprightCubeHasItsTopAndItsHeight) {
  const auto blocks = as_start_blocks({cube_at({0.0, 0.0, 2.0})});
  const ColumnGrid grid = column_grid(-0.5, 1.0, -0.5, 1.0, 0.125);
  const Columns c = columns_through(grid, blocks, start_snapshot(blocks).states, {1});
  for (int j = 0; j < grid.ny; ++j) {
    for (int i = 0; i < grid.nx; ++i) {
      const bool inside = grid.x(i) > 0 && grid.x(i) < 0.5 && grid.y(j) > 0 && grid.y(j) < 0.5;
      EXPECT_EQ(c.top_block[grid.at(i, j)], inside ? 0 : -1);
      EXPECT_DOUBLE_EQ(c.top[grid.at(i, j)], inside ? 2.5 : kNoRock);
      EXPECT_DOUBLE_EQ(c.length[grid.at(i, j)], inside ? 0.5 : 0.0);
    }
  }
}

TEST(Columns, CubeOnItsEdgeIsARoof) {
  const auto blocks = as_start_blocks({cube_at({-0.25, -0.25, -0.25})});
  Snapshot s = start_snapshot(blocks);
  s.states[0].rotation = Quat(Eigen::AngleAxisd(0.25 * std::numbers::pi, Vec3::UnitY()));
  const ColumnGrid grid = column_grid(-0.5, 0.5, -0.25, 0.25, 0.05);
  const Columns c = columns_through(grid, blocks, s.states, {1});
  const double ridge = 0.25 * std::numbers::sqrt2;
  for (int i = 0; i < grid.nx; ++i) {
    const double expected = ridge - std::abs(grid.x(i));  // 45 degree slopes
    if (expected < 0.0) continue;
    EXPECT_NEAR(c.top[grid.at(i, 3)], expected, 1e-12);
    EXPECT_NEAR(c.length[grid.at(i, 3)], 2.0 * expected, 1e-12);
  }
}

TEST(Columns, LengthTimesAreaIsTheVolumeOfTheRock) {
  const BenchRun run = bench_run();
  const Extent extent = extent_of(run.blocks, run.last.states);
  const ColumnGrid grid =
      column_grid(extent.low.x(), extent.high.x(), extent.low.y(), extent.high.y(), 0.1);
  const Columns c =
      columns_through(grid, run.blocks, run.last.states, std::vector<char>(run.blocks.size(), 1));
  const double volume = std::accumulate(c.length.begin(), c.length.end(), 0.0) * grid.dx * grid.dy;
  // 5 columns to a cube's edge, so every cube is hit by exactly 25 columns: only rounding remains.
  EXPECT_NEAR(volume, static_cast<double>(run.blocks.size()) * 0.125, 1e-9 * volume);
}

// Two thirds of the cubes lie deep below others.
TEST(Columns, TopsAloneAreThoseOfAllBlocks) {
  BenchRun run = bench_run();
  for (size_t b = 0; b < run.blocks.size(); b += 3)  // some stand askew
    run.last.states[b].rotation = Quat(Eigen::AngleAxisd(0.3, Vec3(1, 2, 3).normalized()));
  const Extent extent = extent_of(run.blocks, run.last.states);
  const ColumnGrid grid =
      column_grid(extent.low.x(), extent.high.x(), extent.low.y(), extent.high.y(), 0.07);
  std::vector<char> keep(run.blocks.size(), 1);
  for (size_t b = 0; b < keep.size(); b += 7) keep[b] = 0;
  const Columns all = columns_through(grid, run.blocks, run.last.states, keep);
  const Columns tops = tops_through(grid, run.blocks, run.last.states, keep);
  EXPECT_EQ(tops.top, all.top);
  EXPECT_TRUE(tops.length.empty());
}

TEST(Section, CutsCubesInSquaresAndTurnedCubesInRhombi) {
  const auto blocks = as_start_blocks(
      {cube_at({0.0, 0.0, 0.0}), cube_at({2.0, 0.0, 0.0}), cube_at({4.0, 3.0, 0.0})});
  Snapshot s = start_snapshot(blocks);
  s.states[1].rotation = Quat(Eigen::AngleAxisd(0.5, Vec3::UnitY()));
  const auto section = section_at(0.2, blocks, s.states);
  ASSERT_EQ(section.size(), 2U);  // the third cube is beside the plane
  EXPECT_EQ(section[0].outline.size(), 4U);
  EXPECT_NEAR(area_of(section[0].outline), 0.25, 1e-12);
  EXPECT_NEAR(area_of(section[1].outline), 0.25, 1e-12);
}

// The top is two polygons, x = 0 and x = 1 are one each: an edge along y at the top belongs to one
// polygon only, the whole one as the halves.
Block cube_with_a_top_of_two() {
  Block block;
  block.shape.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},   {0, 0, 1},
                          {1, 0, 1}, {1, 1, 1}, {0, 1, 1}, {0, 0.5, 1}, {1, 0.5, 1}};
  block.shape.faces = {{0, 3, 2, 1}, {0, 1, 5, 4}, {2, 3, 7, 6}, {0, 4, 7, 3},
                       {1, 2, 6, 5}, {4, 5, 9, 8}, {8, 9, 6, 7}};
  block.mass = mass_properties(block.shape);
  return block;
}

TEST(Section, CutsFacesOfSeveralPolygonsWhole) {
  const auto blocks = as_start_blocks({cube_with_a_top_of_two()});
  for (const double y : {0.2, 0.7}) {
    const auto section = section_at(y, blocks, start_snapshot(blocks).states);
    ASSERT_EQ(section.size(), 1U);
    EXPECT_NEAR(area_of(section[0].outline), 1.0, 1e-12);
  }
}

TEST(Section, CutsACubeAcrossItsDiagonalInAHexagon) {
  const auto blocks = as_start_blocks({cube_at({-0.25, -0.25, -0.25})});
  Snapshot s = start_snapshot(blocks);
  s.states[0].rotation = Quat::FromTwoVectors(Vec3(1, 1, 1), Vec3::UnitY());
  const auto section = section_at(0.0, blocks, s.states);
  ASSERT_EQ(section.size(), 1U);
  EXPECT_EQ(section[0].outline.size(), 6U);
  // Regular hexagon of side edge/sqrt(2): area 3 sqrt(3)/2 * edge^2/2.
  EXPECT_NEAR(area_of(section[0].outline), 0.75 * std::sqrt(3.0) * 0.25, 1e-12);
}

}  // namespace
}  // namespace muckpile
