// SPDX-License-Identifier: GPL-2.0-or-later
// Measures of a crater, against one dug from cubes by hand: a cylinder 4 m in radius and 2 m deep.
// Scope: measure/crater, measure/launch.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "measure/broken_out.h"
#include "measure/crater.h"
#include "measure/launch.h"
#include "synthetic_run.h"

namespace muckpile {
namespace {

using namespace testing;

double moved_volume(const BenchRun& run, const std::vector<char>& moved) {
  double volume = 0.0;
  for (size_t b = 0; b < moved.size(); ++b) volume += moved[b] * run.blocks[b].volume;
  return volume;
}

std::vector<CraterRing> rings_of(const BenchRun& run, const std::vector<char>& moved) {
  return crater_rings(run.blocks, run.last, moved, 0.125, kCube,
                      std::vector<char>(run.blocks.size(), 1));
}

TEST(Crater, TrueAndApparentAgreeWhenNothingFallsBack) {
  const BenchRun run = crater_run();
  const auto moved = broken_out(run.blocks, run.last.states, kCube);
  const auto rings = rings_of(run, moved);
  // A rim of cubes is ragged by half a cube about the circle.
  const CraterShape whole = true_crater(rings), apparent = apparent_crater(rings);
  EXPECT_NEAR(whole.radius, 4.0, 0.5 * kCube);
  EXPECT_NEAR(whole.depth, 2.0, 1e-9);
  // Corners of rim cubes beyond the radius are not counted: a strip of 0.1 m about the 4 m is 5 %.
  EXPECT_NEAR(whole.volume, moved_volume(run, moved), 0.05 * whole.volume);
  // The apparent crater ends where nothing is lower than before: the outermost corner of the rim.
  EXPECT_GE(apparent.radius, whole.radius);
  EXPECT_LE(apparent.radius, 4.0 + 1.5 * kCube);
  EXPECT_NEAR(apparent.volume, moved_volume(run, moved), 0.01 * apparent.volume);
}

TEST(Crater, FallbackFillsTheApparentCraterOnly) {
  BenchRun run = crater_run();
  // Two of the four layers come back, turned over and loosened by nothing: 1 m of fill, 1 m of
  // crater left.
  for (size_t b = 0; b < run.blocks.size(); ++b) {
    const Vec3& start = run.blocks[b].centroid;
    if (start.head<2>().norm() < 4.0 && start.z() > -1.0)
      run.last.states[b].centre = {start.x(), start.y(), start.z() - 1.0};
  }
  const auto moved = broken_out(run.blocks, run.last.states, kCube);
  const auto rings = rings_of(run, moved);
  EXPECT_NEAR(true_crater(rings).depth, 2.0, 1e-9);
  EXPECT_NEAR(apparent_crater(rings).depth, 1.0, 1e-9);
  EXPECT_NEAR(apparent_crater(rings).volume, 0.5 * moved_volume(run, moved),
              0.01 * moved_volume(run, moved));
}

TEST(Crater, EjectaAreCountedByWhereTheyEnd) {
  const BenchRun run = crater_run();
  const auto moved = broken_out(run.blocks, run.last.states, kCube);
  const Ejecta ejecta = ejecta_beyond(5.0, run.blocks, run.last, moved);
  EXPECT_NEAR(ejecta.mass, moved_volume(run, moved) * kDensity, 1e-6);
  EXPECT_NEAR(ejecta.p50, 20.0, 0.5);  // thrown by 20 m along x, a disc centred on the axis before
  EXPECT_LE(ejecta.p50, ejecta.p90);
  EXPECT_LE(ejecta.p90, ejecta.max);
  EXPECT_NEAR(ejecta.max, 23.75, 0.2);
  EXPECT_TRUE(std::isnan(ejecta_beyond(100.0, run.blocks, run.last, moved).p50));
  // Of a disc of 4 m radius what lay within 2 m is a quarter; the rest is not of that crater.
  EXPECT_NEAR(ejecta_beyond(2.0, run.blocks, run.last, moved).mass, 0.25 * ejecta.mass,
              0.03 * ejecta.mass);
}

TEST(Crater, IsEmptyWhereNothingMoved) {
  BenchRun run = crater_run();
  run.last = start_snapshot(run.blocks);
  const auto rings = rings_of(run, std::vector<char>(run.blocks.size(), 0));
  EXPECT_EQ(true_crater(rings).volume, 0.0);
  EXPECT_EQ(apparent_crater(rings).volume, 0.0);
}

// The surface of the made-up rock has 40 by 40 cubes; those of one ring fly alike.
TEST(Launch, RingsOfTheSurfaceHaveTheMeanOfTheirBlocks) {
  BenchRun run = crater_run();
  run.last = start_snapshot(run.blocks);
  for (size_t b = 0; b < run.blocks.size(); ++b) {
    const Vec3& start = run.blocks[b].centroid;
    const Eigen::Vector2d away = start.head<2>().normalized();
    run.last.states[b].velocity = {0.5 * away.x(), 0.5 * away.y(), start.z() > -kCube ? 3.0 : 9.0};
  }
  double mass = 0.0;
  for (const SurfaceRing& ring : surface_rings(run.blocks, 2.0)) {
    const RingVelocity mean = velocity_of(ring, run.blocks, run.last);
    EXPECT_NEAR(mean.outward, 0.5, 1e-12);
    EXPECT_NEAR(mean.upward, 3.0, 1e-12);  // no cube below the first layer counts
    mass += ring.mass;
  }
  EXPECT_NEAR(mass, 1600 * kDensity * kCube * kCube * kCube, 1e-6 * mass);
}

TEST(Launch, RingsLieWhereTheirBlocksStarted) {
  const BenchRun run = crater_run();
  const auto rings = surface_rings(run.blocks, 2.0);
  for (size_t k = 0; k < 5; ++k) {  // whole rings; the corners of the rock lie beyond
    EXPECT_GT(rings[k].radius, 2.0 * static_cast<double>(k));
    EXPECT_LT(rings[k].radius, 2.0 * static_cast<double>(k + 1));
  }
}

}  // namespace
}  // namespace muckpile
