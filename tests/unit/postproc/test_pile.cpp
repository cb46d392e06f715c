// SPDX-License-Identifier: GPL-2.0-or-later
// Measures of a muck pile, against a pile built from cubes by hand.
// Scope: measure/pile, measure/broken_out, measure/face_velocity.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "measure/broken_out.h"
#include "measure/face_velocity.h"
#include "measure/height_map.h"
#include "measure/pile.h"
#include "synthetic_run.h"

namespace muckpile {
namespace {

using namespace testing;

constexpr double kCell = 0.125;  // four to a cube's edge, so columns miss no cube

std::vector<char> all_of(const BenchRun& run) { return std::vector<char>(run.blocks.size(), 1); }

struct MeasuredBench {
  BenchRun run = bench_run();
  std::vector<char> moved = broken_out(run.blocks, run.last.states, kCube);
  PileProfile profile = pile_profile(run.blocks, run.last, moved, kCell, all_of(run));
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
  // As long as the pile is high is nine steps and a little: a stretch may end inside a step, which
  // changes the slope by a few per cent.
  ASSERT_EQ(m.profile.sections.size(), 2u);  // 2 m wide, two cubes of 0.5 m each
  for (const auto& section : m.profile.sections) {
    for (size_t i = 0; i < section.size(); ++i) EXPECT_NEAR(section[i], m.profile.pile[i], 1e-8);
  }
  EXPECT_NEAR(std::tan(m.shape.rest_angle), kLayer, 0.03 * kLayer);
}

// A floor at `z` for x > 0.001 m.
PitFloor floor_at(double z) {
  const Vec3 a(0.001, -50, z), b(50, -50, z), c(50, 50, z), d(0.001, 50, z);
  return PitFloor({{a, b, c}, {a, c, d}}, "floor");
}

TEST(PitFloor, IsStraightBetweenTheToeAndWhereItBegins) {
  const Vec3 a(4, -9, -1), b(40, -9, -10), c(40, 9, -10), d(4, 9, -1);  // falls by 1 in 4
  const PitFloor floor({{a, b, c}, {a, c, d}}, "floor");
  EXPECT_EQ(floor.at(-3.0, 1.0), 0.0);
  EXPECT_NEAR(floor.at(1.0, 1.0), -0.25, 1e-12);
  EXPECT_NEAR(floor.at(4.0, -5.0), -1.0, 1e-12);
  EXPECT_NEAR(floor.at(20.0, 5.0), -5.0, 1e-12);
  EXPECT_EQ(PitFloor().at(20.0, 5.0), 0.0);
}

// The same pile lies a metre lower: all that is measured above the floor stays.
TEST(PitFloor, APileIsMeasuredAboveIt) {
  MeasuredBench m;
  const std::vector<char> all = all_of(m.run);
  const HeightMap level = height_map(m.run.blocks, m.run.last, m.moved, all, kCell);
  for (size_t b = 0; b < m.moved.size(); ++b)
    if (m.moved[b] != 0) m.run.last.states[b].centre.z() -= 1.0;
  const PileProfile lower =
      pile_profile(m.run.blocks, m.run.last, m.moved, kCell, all, {}, floor_at(-1.0));
  const PileShape shape = pile_shape(lower, kBurden, mean_block_size(m.run.blocks, m.moved));
  EXPECT_NEAR(shape.height, m.shape.height, 1e-8);
  EXPECT_NEAR(shape.toe, m.shape.toe, 1e-8);
  EXPECT_NEAR(shape.swell, m.shape.swell, 1e-8);
  EXPECT_NEAR(shape.bulk_volume, m.shape.bulk_volume, 1e-6);
  EXPECT_NEAR(shape.front_angle, m.shape.front_angle, 1e-8);
  EXPECT_NEAR(shape.rest_angle, m.shape.rest_angle, 1e-8);
  EXPECT_NEAR(at(lower, lower.mean, 7.3), 7 * kLayer - 1.0, 1e-8);  // over z = 0
  const HeightMap map = height_map(m.run.blocks, m.run.last, m.moved, all, kCell, floor_at(-1.0));
  EXPECT_NEAR(map.pile_volume, level.pile_volume, 1e-6);
  EXPECT_NEAR(map.solid_volume, level.solid_volume, 1e-9);
}

// Falls from 6 m at x = 0 by `upper` in 1 as far as `bend` [m], then by `lower` in 1 to the floor;
// columns of 0.1 m.
std::vector<double> bent_slope(double upper, double bend, double lower) {
  std::vector<double> z;
  for (int i = 0; i < 200; ++i) {
    const double x = (i + 0.5) * 0.1;
    z.push_back(std::max(0.0, 6.0 - upper * std::min(x, bend) - lower * std::max(0.0, x - bend)));
  }
  return z;
}

std::vector<double> straight_slope(double slope) { return bent_slope(slope, 20.0, slope); }

PileProfile profile_of(const std::vector<std::vector<double>>& sections) {
  PileProfile p{};
  p.dx = 0.1;
  p.width = static_cast<double>(sections.size());
  p.sections = sections;
  p.pile.assign(sections[0].size(), 0.0);
  for (size_t i = 0; i < p.pile.size(); ++i) {
    p.x.push_back((static_cast<double>(i) + 0.5) * p.dx);
    for (const auto& z : sections) p.pile[i] += z[i] / static_cast<double>(sections.size());
  }
  p.pile_length = p.pile;
  return p;
}

constexpr double kThin = 0.01;  // [m] block size that counts every sample above the floor

double rest_slope_of(const PileProfile& p) {
  return std::tan(pile_shape(p, 0.0, kThin).rest_angle);
}

// Least-squares line through the first samples of `z`, of slope's sign turned.
double fall_of_first(const std::vector<double>& z, int samples) {
  double xz = 0.0, xx = 0.0;
  for (int i = 0; i < samples; ++i) {
    const double x = 0.1 * (i - 0.5 * (samples - 1));
    xz += x * z[static_cast<size_t>(i)];
    xx += x * x;
  }
  return -xz / xx;
}

TEST(RestAngle, OfALowPileIsTakenOverFourBlocks) {
  // 1.2 m high, steep for 0.4 m only: a stretch of 1.2 m would be that of one and a half blocks.
  std::vector<double> z;
  for (int i = 0; i < 60; ++i) {
    const double x = (i + 0.5) * 0.1;
    z.push_back(1.2 - std::min(x, 0.4) * 0.5 - std::max(0.0, x - 0.4) * 0.03);
  }
  constexpr double kBlock = 0.8;
  const double slope = std::tan(pile_shape(profile_of({z}), 0.0, kBlock).rest_angle);
  const double over_its_height = fall_of_first(z, 12), over_four_blocks = fall_of_first(z, 32);
  EXPECT_NEAR(slope, over_four_blocks, 0.03 * over_four_blocks);
  EXPECT_GT(over_its_height, 1.5 * over_four_blocks);
}

TEST(RestAngle, OfAStraightSlopeIsThatSlope) {
  EXPECT_NEAR(rest_slope_of(profile_of({straight_slope(0.4)})), 0.4, 1e-9);
}

TEST(RestAngle, OfASlopeShorterThanThePileIsHighIsThatSlope) {
  EXPECT_NEAR(rest_slope_of(profile_of({straight_slope(2.0)})), 2.0, 1e-9);
}

TEST(RestAngle, IsThatOfTheSteepestStretch) {
  // 1.2 m at 0.4 over 3 m, then 4.8 m at 0.8 over 6 m, which is the pile's height.
  EXPECT_NEAR(rest_slope_of(profile_of({bent_slope(0.4, 3.0, 0.8)})), 0.8, 1e-9);
}

TEST(RestAngle, HardlyFeelsOneBlockOnTheSlope) {
  std::vector<double> z = straight_slope(0.4);
  for (size_t i = 40; i < 45; ++i) z[i] += 0.25;
  // The steepest stretch of n = 60 samples begins on the block. Its line is steeper by
  // 12 * 0.25 m * (29.5 + 28.5 + 27.5 + 26.5 + 25.5) / (0.1 m * n (n^2 - 1)) = 412.5 / 21594.
  EXPECT_NEAR(rest_slope_of(profile_of({z})), 0.4 + 412.5 / 21594.0, 1e-9);
}

TEST(RestAngle, DoesNotFeelThatTheFrontIsNotStraightAcrossTheWidth) {
  std::vector<double> ahead = straight_slope(0.4);
  std::rotate(ahead.begin(), ahead.end() - 20, ahead.end());  // 2 m farther out
  std::fill_n(ahead.begin(), 20, 6.0);
  const PileProfile p = profile_of({straight_slope(0.4), ahead});
  EXPECT_NEAR(rest_slope_of(p), 0.4, 1e-9);
}

TEST(RestAngle, IsTheMeanOfTheSections) {
  EXPECT_NEAR(rest_slope_of(profile_of({straight_slope(0.4), straight_slope(0.8)})), 0.6, 1e-9);
}

TEST(PileShape, HasNoSlopeOrToeWithoutAPile) {
  BenchRun run = bench_run();
  run.last = start_snapshot(run.blocks);
  const std::vector<char> moved = broken_out(run.blocks, run.last.states, kCube);
  const PileShape shape =
      pile_shape(pile_profile(run.blocks, run.last, moved, kCell, all_of(run)), kBurden, 0.0);
  EXPECT_TRUE(std::isnan(shape.height));
  EXPECT_TRUE(std::isnan(shape.toe));
  EXPECT_TRUE(std::isnan(shape.swell));
  EXPECT_TRUE(std::isnan(shape.front_angle));
  EXPECT_TRUE(std::isnan(shape.rest_angle));
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
  EXPECT_NEAR(m.thrown.prism_volume, 840 * 0.125, 1e-9);
  EXPECT_DOUBLE_EQ(m.thrown.beyond_toe, 1.0);
  EXPECT_GT(m.thrown.largest, m.thrown.centre_of_mass);
}

TEST(Throw, CountsAsBeyondTheToeOnlyWhatEndsThere) {
  const auto blocks = as_start_blocks(
      {cube_at({-1.0, 0.0, 1.0}), cube_at({-2.0, 0.0, 1.0}), cube_at({-9.0, 0.0, 1.0})});
  Snapshot s = start_snapshot(blocks);
  s.states[0].centre.x() = 3.25;   // from -0.75: 4 m
  s.states[1].centre.x() = -0.75;  // from -1.75: 1 m
  s.states[2].centre.x() = 9.0;    // behind the burden: not of the prism
  const Throw t = throw_of(blocks, s, kBurden);
  EXPECT_NEAR(t.centre_of_mass, 2.5, 1e-12);
  EXPECT_NEAR(t.beyond_toe, 0.5, 1e-12);
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
