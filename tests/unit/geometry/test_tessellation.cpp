// SPDX-License-Identifier: GPL-2.0-or-later
// Blocks fill the rock exactly, share faces, follow the size law, keep out of holes and air.
// Scope: scenes of a few hundred to two thousand blocks; lengths in metres.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <barrier>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <thread>
#include <vector>

#include "geometry/cut/cell_cutter.h"
#include "geometry/cut/tessellation.h"
#include "geometry/holes/hole_surface.h"
#include "input_error_of.h"
#include "math/random.h"
#include "shapes.h"

namespace muckpile {
namespace {

// A 3 x 2 x 3 m box around an inclined charge of 2 m, blocks 0.1 m at the hole to 0.5 m far away.
TessellationOptions blast_options() {
  TessellationOptions options;
  options.lo = Vec3(-1.5, -1.0, 0.0);
  options.hi = Vec3(1.5, 1.0, 3.0);
  options.holes = {{Vec3(-0.2, 0.0, 0.5), Vec3(0.2, 0.1, 2.4), 0.15}};
  options.size = SizeLaw::power({0.4, 1.2}, {0.1, 0.5});
  options.sweeps = 15;
  options.seed = 7;
  return options;
}

const Tessellation& blast() {
  static const Tessellation cells = tessellate(blast_options());
  return cells;
}

// Bench profile: air where x > 0 and z > 0, so a vertical face meets a horizontal floor.
TessellationOptions bench_options() {
  TessellationOptions options;
  options.lo = Vec3(-1.5, 0.0, -1.0);
  options.hi = Vec3(1.5, 1.5, 1.5);
  options.size = SizeLaw::uniform(0.25);
  options.sweeps = 12;
  options.region = test::bench_profile();
  return options;
}

std::string message_of(const TessellationOptions& options) {
  return input_error_of([&] { (void)tessellate(options); });
}

void expect_closed_blocks(const Tessellation& cells) {
  for (const Block& block : cells.blocks) {
    const double area = std::pow(block.mass.volume, 2.0 / 3.0);
    EXPECT_GT(block.mass.volume, 0.0);
    EXPECT_LT(area_vector_sum(block.shape).norm(), 1e-9 * area);  // rounding of 15 faces: 1e-14
    ASSERT_EQ(block.neighbour.size(), block.shape.faces.size());
    // Euler: V - E + F = 2, with E half the sum of the faces' corners.
    std::size_t corners = 0;
    for (const auto& face : block.shape.faces) corners += face.size();
    EXPECT_EQ(2 * block.shape.vertices.size() + 2 * block.shape.faces.size(), corners + 4);
  }
}

// Both blocks have the face, with opposite normals, the same area and the same centroid.
void expect_shared_faces(const std::vector<Block>& blocks) {
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    for (std::size_t f = 0; f < blocks[i].neighbour.size(); ++f) {
      const int j = blocks[i].neighbour[f];
      if (j < 0) continue;
      const Block& other = blocks[static_cast<std::size_t>(j)];
      const auto back =
          std::find(other.neighbour.begin(), other.neighbour.end(), static_cast<int>(i));
      ASSERT_NE(back, other.neighbour.end());
      const FaceGeometry mine = face_geometry(blocks[i].shape, static_cast<int>(f));
      const FaceGeometry theirs =
          face_geometry(other.shape, static_cast<int>(back - other.neighbour.begin()));
      const double area = std::pow(blocks[i].mass.volume, 2.0 / 3.0);
      // Vertices are found twice, each to about 1e-11 m (voro++'s own tolerance).
      EXPECT_NEAR(mine.area, theirs.area, 1e-9 * area);
      if (mine.area < 1e-6 * area) continue;
      EXPECT_LT((mine.centroid - theirs.centroid).norm(), 1e-8);
      EXPECT_LT((mine.normal + theirs.normal).norm(), 1e-6);
    }
  }
}

/// Runs `member` for each of three members of a team, in threads.
void in_team_of_three(TessellationOptions options,
                      const std::function<void(const TessellationOptions&)>& member) {
  constexpr int kMembers = 3;
  std::array<std::vector<double>, kMembers> given;
  std::barrier all(kMembers);
  std::vector<std::thread> threads;
  for (int k = 0; k < kMembers; ++k) {
    options.team = {k, kMembers, [&, k](const std::vector<double>& mine) {
                      given[static_cast<std::size_t>(k)] = mine;
                      all.arrive_and_wait();
                      std::vector<double> joined;
                      for (const auto& part : given)
                        joined.insert(joined.end(), part.begin(), part.end());
                      all.arrive_and_wait();
                      return joined;
                    }};
    threads.emplace_back([&member, options] { member(options); });
  }
  for (std::thread& thread : threads) thread.join();
}

TEST(Tessellation, SharedSweepsGiveTheSameBlocksToTheLastBit) {
  Tessellation shared;
  in_team_of_three(blast_options(), [&](const TessellationOptions& mine) {
    if (mine.team.rank == 1)
      shared = tessellate(mine);
    else
      share_sweeps(mine);
  });
  ASSERT_EQ(shared.blocks.size(), blast().blocks.size());
  for (std::size_t b = 0; b < shared.blocks.size(); ++b) {
    EXPECT_EQ(shared.blocks[b].shape.vertices, blast().blocks[b].shape.vertices) << b;
    EXPECT_EQ(shared.blocks[b].neighbour, blast().blocks[b].neighbour) << b;
  }
}

TEST(Tessellation, FillsABoxExactly) {
  const Tessellation cells = test::cube_of_blocks(6.0, 5, 1);
  EXPECT_NEAR(cells.statistics.block_volume, 216.0, 216.0 * 1e-9);
  EXPECT_NEAR(cells.statistics.void_volume, 0.0, 216.0 * 1e-9);
  EXPECT_NEAR(static_cast<double>(cells.blocks.size()), 216.0, 1.0);
  expect_closed_blocks(cells);
  expect_shared_faces(cells.blocks);
}

TEST(Tessellation, CellsAreTheVoronoiCellsOfAllPoints) {
  Random random(5);
  std::vector<Vec3> points;
  for (int k = 0; k < 400; ++k) {  // 64 times denser in one corner
    const Vec3 p(random.uniform(), random.uniform(), random.uniform());
    points.push_back(k % 2 == 0 ? p : Vec3(0.25 * p));
  }
  CellCutter cutter(points, Vec3::Zero(), Vec3::Ones());
  double volume = 0.0;
  Polyhedron shape;
  std::vector<int> behind;
  for (int i = 0; i < 400; ++i) {
    ASSERT_TRUE(cutter.cut(i, 0.01));  // a guess far too short
    cutter.extract(shape, behind);
    volume += mass_properties(shape).volume;
    for (const Vec3& v : shape.vertices) {
      const double own = (v - points[static_cast<std::size_t>(i)]).norm();
      for (const Vec3& other : points) ASSERT_GT((v - other).norm(), own - 1e-10);
    }
  }
  EXPECT_NEAR(volume, 1.0, 1e-10);
}

TEST(Tessellation, BlocksAroundAHoleAreClosedAndShareFaces) {
  expect_closed_blocks(blast());
  expect_shared_faces(blast().blocks);
}

TEST(Tessellation, FollowsTheSizeLaw) {
  std::vector<double> ratios;
  double smallest = 1.0, largest = 0.0;
  for (const Block& block : blast().blocks) {
    const double size = std::cbrt(block.mass.volume);
    ratios.push_back(size / block.target_size);
    smallest = std::min(smallest, size);
    largest = std::max(largest, size);
  }
  std::sort(ratios.begin(), ratios.end());
  const std::size_t n = ratios.size();
  EXPECT_NEAR(ratios[n / 2], 1.0, 0.03);  // measured 1.00
  EXPECT_GT(ratios[n / 20], 0.85);        // measured 0.92
  EXPECT_LT(ratios[n - n / 20], 1.15);    // measured 1.09
  EXPECT_LT(smallest, 0.11);
  EXPECT_GT(largest, 0.45);
  EXPECT_NEAR(blast().statistics.median_size_ratio, ratios[n / 2], 1e-12);
  EXPECT_NEAR(static_cast<double>(n), blast().statistics.expected_blocks,
              0.02 * static_cast<double>(n));
}

TEST(Tessellation, WhatIsMissingIsTheHole) {
  const TessellationStatistics& s = blast().statistics;
  // Two independent ways to the same volume: box minus blocks, and the divergence theorem on the
  // hole's faces, which holds only if they enclose it completely.
  EXPECT_NEAR(s.hole_volume[0], s.void_volume, 1e-9 * s.box_volume);
  const double length = (Vec3(0.2, 0.1, 2.4) - Vec3(-0.2, 0.0, 0.5)).norm();
  const double cylinder = std::numbers::pi * 0.15 * 0.15 * length;
  EXPECT_NEAR(s.cylinder_volume[0], cylinder, 1e-12);
  EXPECT_NEAR(s.hole_volume[0], cylinder, 0.02 * cylinder);  // radius feedback of the last sweep
  // A prism of ten sides with the cylinder's volume has 1.7 % more side area; rough ends add.
  const double area = 2.0 * std::numbers::pi * 0.15 * (length + 0.15);
  EXPECT_GT(s.hole_area[0], area);
  EXPECT_LT(s.hole_area[0], 1.12 * area);
}

TEST(Tessellation, TheFacesOfAHoleCloseUp) {
  Vec3 sum = Vec3::Zero();
  double area = 0.0;
  for (const Block& block : blast().blocks) {
    for (std::size_t f = 0; f < block.neighbour.size(); ++f) {
      if (block.neighbour[f] != hole_face(0)) continue;
      const FaceGeometry face = face_geometry(block.shape, static_cast<int>(f));
      sum += face.area * face.normal;
      area += face.area;
    }
  }
  EXPECT_GT(area, 1.0);
  EXPECT_LT(sum.norm(), 1e-9 * area);
}

TEST(Tessellation, NoBlockReachesIntoAHoleEvenWithoutSweeps) {
  TessellationOptions options = blast_options();
  options.sweeps = 0;  // irregular cells, and no shrinking of the mirrored radius
  const Tessellation cells = tessellate(options);
  Hole core = options.holes[0];  // a hair smaller, for vertices that touch within rounding
  const Vec3 axis = core.collar - core.toe;
  core.radius *= 1.0 - 1e-9;
  core.toe += 1e-9 * axis;
  core.collar -= 1e-9 * axis;
  for (const Block& block : cells.blocks) {
    for (const Vec3& v : block.shape.vertices) EXPECT_FALSE(inside_hole(core, v));
  }
  EXPECT_GT(cells.statistics.hole_volume[0], cells.statistics.cylinder_volume[0]);
}

TEST(Tessellation, AHoleThatEndsAtTheSurfaceKeepsItsVolume) {
  TessellationOptions options = blast_options();
  options.holes = {{Vec3(0, 0, 1.0), Vec3(0, 0, 3.0), 0.15}};
  const TessellationStatistics s = tessellate(options).statistics;
  EXPECT_NEAR(s.hole_volume[0], s.void_volume, 1e-9 * s.box_volume);
  EXPECT_NEAR(s.hole_volume[0], std::numbers::pi * 0.15 * 0.15 * 2.0, 0.003);  // 2 %
}

TEST(Tessellation, HalfAHoleOnASymmetryPlaneHasHalfTheVolume) {
  TessellationOptions options = blast_options();
  options.holes = {{Vec3(-1.5, 0, 1.0), Vec3(-1.5, 0, 2.5), 0.15}};
  const TessellationStatistics s = tessellate(options).statistics;
  const double half = 0.5 * std::numbers::pi * 0.15 * 0.15 * 1.5;
  EXPECT_NEAR(s.cylinder_volume[0], half, 0.02 * half);
  EXPECT_NEAR(s.hole_volume[0], s.void_volume, 1e-9 * s.box_volume);
  EXPECT_NEAR(s.hole_volume[0], half, 0.04 * half);
}

TEST(Tessellation, TwoHolesKeepTheirOwnFaces) {
  TessellationOptions options = blast_options();
  options.holes = {{Vec3(-0.8, 0, 0.8), Vec3(-0.8, 0, 2.0), 0.15},
                   {Vec3(0.8, 0, 1.0), Vec3(0.8, 0, 2.0), 0.12}};
  const TessellationStatistics s = tessellate(options).statistics;
  EXPECT_NEAR(s.hole_volume[0] + s.hole_volume[1], s.void_volume, 1e-9 * s.box_volume);
  EXPECT_NEAR(s.hole_volume[0], s.cylinder_volume[0], 0.02 * s.cylinder_volume[0]);
  EXPECT_NEAR(s.hole_volume[1], s.cylinder_volume[1], 0.02 * s.cylinder_volume[1]);
}

TEST(Tessellation, ARegionIsCutAtItsFaceAndFloor) {
  const Tessellation cells = tessellate(bench_options());
  expect_closed_blocks(cells);
  expect_shared_faces(cells.blocks);
  const double rock = 3.0 * 1.5 * 2.5 - 1.5 * 1.5 * 1.5;
  // Blocks stop at the planes; only along the inner edge, 1.5 m long, a chamfer of up to one
  // block's section is lost (measured 0.6 of it).
  EXPECT_LE(cells.statistics.block_volume, rock * (1.0 + 1e-9));
  EXPECT_GT(cells.statistics.block_volume, rock - 1.5 * 0.25 * 0.25);
  double face_area = 0.0;
  for (const Block& block : cells.blocks) {
    for (const Vec3& v : block.shape.vertices) EXPECT_LT(std::min(v.x(), v.z()), 1e-9);
    for (std::size_t f = 0; f < block.neighbour.size(); ++f) {
      const FaceGeometry face = face_geometry(block.shape, static_cast<int>(f));
      if (block.neighbour[f] != kFreeFace || std::abs(face.centroid.x()) > 1e-9) continue;
      if (face.normal.x() > 1.0 - 1e-9) face_area += face.area;
    }
  }
  // The bench face, 1.5 m by 1.5 m, less the chamfer, 1.5 m by about one block.
  EXPECT_LT(face_area, 1.5 * 1.5 + 1e-9);
  EXPECT_GT(face_area, 1.5 * (1.5 - 1.5 * 0.25));
}

TEST(Tessellation, TheSeedDecides) {
  const Tessellation first = test::cube_of_blocks(4.0, 3, 1);
  const Tessellation again = test::cube_of_blocks(4.0, 3, 1);
  const Tessellation other = test::cube_of_blocks(4.0, 3, 2);
  ASSERT_EQ(first.blocks.size(), again.blocks.size());
  for (std::size_t b = 0; b < first.blocks.size(); ++b) {
    EXPECT_EQ(first.blocks[b].shape.vertices, again.blocks[b].shape.vertices);
    EXPECT_EQ(first.blocks[b].neighbour, again.blocks[b].neighbour);
  }
  EXPECT_GT((first.blocks[0].mass.centroid - other.blocks[0].mass.centroid).norm(), 1e-3);
}

TEST(Tessellation, ExpectedCountIsTheIntegralOfTheDensity) {
  // Around an axis through the whole box, s = 0.5 r clipped at 0.1 and 0.5: 1/s^3 integrated over
  // the square by polar midpoints.
  TessellationOptions options;
  options.lo = Vec3(-1, -1, 0);
  options.hi = Vec3(1, 1, 2);
  options.holes = {{Vec3(0, 0, 0), Vec3(0, 0, 2), 0.15}};
  options.size = SizeLaw::power({0.5, 1.0}, {0.1, 0.5});
  double expected = 0.0;
  constexpr int kGrid = 1000;
  for (int i = 0; i < kGrid; ++i) {
    for (int j = 0; j < kGrid; ++j) {
      const double r = std::hypot((i + 0.5) / kGrid, (j + 0.5) / kGrid);
      if (r > 0.15) expected += 4.0 * 2.0 / (kGrid * kGrid) / std::pow(options.size.at(r), 3);
    }
  }
  // Eight points per leaf of one block: 2 %.
  EXPECT_NEAR(expected_block_count(options, 1e9), expected, 0.02 * expected);
}

TEST(Tessellation, RefusesTooManyBlocksBeforeMakingThem) {
  TessellationOptions options = blast_options();
  options.max_blocks = 400;
  EXPECT_NE(message_of(options).find("more than 400 blocks are expected"), std::string::npos);
  options.size = SizeLaw::uniform(1e-3);  // 1.8e10 blocks: counting must stop early
  options.max_blocks = 1000;
  EXPECT_NE(message_of(options).find("more than 1000 blocks are expected"), std::string::npos);
}

TEST(Tessellation, NamesWhatIsWrong) {
  const auto message = [](const std::function<void(TessellationOptions&)>& spoil) {
    TessellationOptions options = blast_options();
    spoil(options);
    return message_of(options);
  };
  EXPECT_EQ(message([](auto& o) { o.hi.z() = 0.0; }),
            "block tessellation: the box edges must be > 0 m, got '3 2 0'");
  EXPECT_EQ(message([](auto& o) { o.sweeps = -1; }),
            "block tessellation: sweeps must be >= 0, got '-1'");
  EXPECT_EQ(message([](auto& o) { o.holes[0].radius = 0.0; }),
            "block tessellation: radius of hole 1 must be > 0 m, got '0'");
  EXPECT_EQ(message([](auto& o) { o.holes[0].collar = o.holes[0].toe; }),
            "block tessellation: hole 1 must have a length > 0 m, got '0'");
  EXPECT_EQ(message([](auto& o) { o.holes[0].collar = Vec3(0, 0, 3.5); }),
            "block tessellation: the axis of hole 1 must lie in the box, got an end at "
            "'0 0 3.5'");
  EXPECT_EQ(message([](auto& o) {
              o.size = SizeLaw::uniform(0.4);
              o.rings = false;
            }),
            "block tessellation: with joint sets, blocks at the wall of hole 1 must be <= its "
            "crushed-zone diameter 0.3 m, got '0.4'; take a block_min below that (inputs: -var "
            "block_min), a wider charge or 'cut voronoi', whose blocks may be three times as wide");
  EXPECT_EQ(message([](auto& o) { o.region.inside = [](const Vec3&) { return true; }; }),
            "block tessellation: a region needs both inside and surface_points");
  const auto no_rock = [](auto& o) {
    o.region.inside = [](const Vec3&) { return false; };
    o.region.surface_points = [](const Vec3&, double) { return std::vector<Vec3>(); };
  };
  EXPECT_EQ(
      message(no_rock).rfind("block tessellation: the axis of hole 1 must lie in the rock", 0), 0u);
  EXPECT_EQ(message([&](auto& o) {
              no_rock(o);
              o.holes.clear();
            }),
            "block tessellation: the rock holds less than one block (expected 0)");
}

}  // namespace
}  // namespace muckpile
