// SPDX-License-Identifier: GPL-2.0-or-later
// Measures of a muck pile, against a pile built from cubes by hand.
// Scope: measure/pile, measure/broken_out, measure/face_velocity.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "measure/broken_out.h"
#include "measure/face_velocity.h"
#include "measure/pile.h"
#include "synthetic_run.h"

namespace muckpile {
namespace {

using namespace testing;

constexpr double kCell = 0.125;  // four to a cube's edge, so columns miss no cube

struct MeasuredBench {
  BenchRun run = bench_run();
  std::vector<char> moved = broken_out(run.blocks, run.last.states, kCube);
  PileProfile profile = pile_profile(run.blocks, run.last, moved, kCell);
  PileShape shape = pile_shape(profile, kBurden, mean_block_size(run.blocks, moved));
  Throw thrown = throw_of(run.blocks, run.last, kBurden);
};

double at(const PileProfile& p, const std::vector<double>& z, double x) {
  return z[static_cast<size_t>(std::lround((x - p.x.front()) / p.dx))];
}

TEST(BrokenOut, IsTheRockThatMovedMoreThanItsOwnSize) {
  const auto blocks = as_start_blocks({cube_at({0, 0, 0}), cube_at({1, 0, 0}), cube_at({2, 0, 0})});
  Snapshot s = start_snapshot(blocks);
  s.states[1].centre.x() += 0.49;
  s.states[2].centre.z() -= 0.51;
  EXPECT_EQ(broken_out(blocks, s.states, 0.1), (std::vector<char>{0, 0, 1}));
  EXPECT_EQ(broken_out(blocks, s.states, 0.6), (std::vector<char>{0, 0, 0}));
}

TEST(PileProfile, ShowsTheBenchBeforeAndTheStepsAfter) {
  const MeasuredBench m;
  EXPECT_EQ(std::ranges::count(m.moved, 1), 4 * 210);
  EXPECT_NEAR(at(m.profile, m.profile.before, -2.0), kBenchHeight, 1e-9);
  EXPECT_NEAR(at(m.profile, m.profile.before, 2.0), 0.0, 1e-9);
  EXPECT_NEAR(at(m.profile, m.profile.mean, -6.0), kBenchHeight,
              1e-9);  // rock behind the burden stays
  EXPECT_NEAR(at(m.profile, m.profile.mean, -2.0), 0.0,
              1e-9);  // the prism is gone, the subdrill zone ends at 0
  EXPECT_NEAR(at(m.profile, m.profile.mean, 0.3), 14 * kLayer,
              1e-8);  // 1e-8: quarter turns by sine and cosine
  EXPECT_NEAR(at(m.profile, m.profile.centre, 7.3), 7 * kLayer, 1e-8);
  EXPECT_NEAR(at(m.profile, m.profile.highest, 13.3), 1 * kLayer, 1e-8);
  EXPECT_NEAR(at(m.profile, m.profile.rock_in_place, 0.3), 0.0, 1e-9);
}

TEST(PileShape, MatchesTheHandBuiltPile) {
  const MeasuredBench m;
  EXPECT_NEAR(m.shape.height, 14 * kLayer, 1e-8);
  EXPECT_GT(m.shape.height_x, 0.0);
  EXPECT_LT(m.shape.height_x, 1.0);
  EXPECT_NEAR(m.shape.toe, 14.0, kCell);  // within one column of the last step's edge
  // Bulk: two columns of each height k * 0.65 m, k = 1..14; solid: two columns of k cubes. The
  // ratio is exact.
  EXPECT_NEAR(m.shape.swell, kLayer / kCube, 1e-8);
  EXPECT_NEAR(m.shape.solid_volume, 4 * 210 * 0.125, 1e-6);
  EXPECT_NEAR(m.shape.bulk_volume, 2.0 * 1.0 * kLayer * 105.0,
              1e-6);  // width * step * sum(k * 0.65)
}

TEST(PileShape, FindsTheSlopeOfTheSteps) {
  const MeasuredBench m;
  // Steps between 20 % (1.82 m) and 80 % (7.28 m) of the height: k = 3..11, nine of them. A
  // straight line through n steps sampled m times each has the slope (n^2 - 1) / (n^2 - 1/m^2) of
  // the stairs, here 0.65 m per m.
  const double n = 9.0, samples = 1.0 / kCell;
  const double slope = kLayer * (n * n - 1.0) / (n * n - 1.0 / (samples * samples));
  EXPECT_NEAR(m.shape.front_angle, std::atan(slope), 1e-7);
  EXPECT_GE(m.shape.steepest_angle,
            m.shape.front_angle);  // a stretch may end inside a step and be steeper
  EXPECT_LT(std::tan(m.shape.steepest_angle),
            kLayer * 1.25);  // four and a half steps: at most (n+1)/n steeper
}

TEST(PileShape, HasNoSlopeOrToeWithoutAPile) {
  BenchRun run = bench_run();
  run.last = start_snapshot(run.blocks);
  const std::vector<char> moved = broken_out(run.blocks, run.last.states, kCube);
  const PileShape shape =
      pile_shape(pile_profile(run.blocks, run.last, moved, kCell), kBurden, 0.0);
  EXPECT_TRUE(std::isnan(shape.height));
  EXPECT_TRUE(std::isnan(shape.toe));
  EXPECT_TRUE(std::isnan(shape.swell));
  EXPECT_TRUE(std::isnan(shape.front_angle));
}

TEST(PileShape, Toe98LeavesTwoPercentOfTheRockBeyond) {
  const MeasuredBench m;
  // 2 % of 105 (cubes per column pair, k = 14..1) is 2.1: the last step (1) and 1.1 of the 2 of the
  // step before, so 0.55 m into the step that ends at 13 m, seen from its far end.
  EXPECT_NEAR(m.shape.toe_98, 13.0 - 0.55, 1e-6);
}

TEST(Throw, IsTheMeanDisplacementOfTheBurdenPrism) {
  const MeasuredBench m;
  // Mean x of the pile: sum over k of k (29 - 2k) / 2 over 105 = 507.5/105; the prism's was -2.5 m.
  EXPECT_NEAR(m.thrown.centre_of_mass, 507.5 / 105.0 + 2.5, 1e-9);
  EXPECT_NEAR(m.thrown.prism_mass, 840 * 0.125 * kDensity, 1e-6);
  EXPECT_DOUBLE_EQ(m.thrown.cast_fraction, 1.0);
  EXPECT_GT(m.thrown.largest, m.thrown.centre_of_mass);
}

TEST(Throw, CastsOnlyWhatEndsBeyondTheFace) {
  const auto blocks = as_start_blocks(
      {cube_at({-1.0, 0.0, 1.0}), cube_at({-2.0, 0.0, 1.0}), cube_at({-9.0, 0.0, 1.0})});
  Snapshot s = start_snapshot(blocks);
  s.states[0].centre.x() = 3.25;   // from -0.75: 4 m
  s.states[1].centre.x() = -0.75;  // from -1.75: 1 m
  s.states[2].centre.x() = 9.0;    // behind the burden: not of the prism
  const Throw t = throw_of(blocks, s, kBurden);
  EXPECT_NEAR(t.centre_of_mass, 2.5, 1e-12);
  EXPECT_NEAR(t.cast_fraction, 0.5, 1e-12);
  EXPECT_NEAR(t.largest, 17.75, 1e-12);
}

TEST(FaceVelocity, TakesTheOuterLayerAtTheMiddleOfTheCharge) {
  const BenchRun run = bench_run();
  // 0.25 * 5 m burden: the layers with centres at -0.25 and -0.75 m; -1.25 m is not within. Heights
  // 4 to 6 m: 4 cubes.
  const std::vector<size_t> layer = face_layer(run.blocks, kBurden, 4.0, 6.0);
  EXPECT_EQ(layer.size(), 2U * 4U * 4U);
  Snapshot s = start_snapshot(run.blocks);
  for (size_t b = 0; b < run.blocks.size(); ++b)
    s.states[b].velocity.x() = run.blocks[b].centroid.x() > -0.5 ? 12.0 : 8.0;
  EXPECT_NEAR(mean_outward_velocity(run.blocks, s, layer), 10.0, 1e-12);
  // A burden of less than four cubes: one cube of the face is deeper than a quarter of it.
  EXPECT_EQ(face_layer(run.blocks, 1.0, 4.0, 6.0).size(), 4U * 4U);
}

}  // namespace
}  // namespace muckpile
