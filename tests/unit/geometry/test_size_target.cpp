// SPDX-License-Identifier: GPL-2.0-or-later
// Size curves and cuts that are made to follow them.
// Scope: one hole in a block of rock.
#include <gtest/gtest.h>

#include <cmath>

#include "args/input_error.h"
#include "geometry/size/size_target.h"

namespace muckpile {
namespace {

constexpr SizeLimits kLimits{0.08, 1.2};

TessellationOptions rock() {
  TessellationOptions options;
  options.lo = {-2.0, -2.0, 0.0};
  options.hi = {2.0, 2.0, 2.0};
  options.holes = {{{0.2, 0.0, 0.2}, {0.2, 0.0, 1.8}, 0.12}};
  options.seed = 5;
  options.sweeps = 10;
  return options;
}

TEST(SizeTarget, KuzRamIsRosinRammlerThroughItsMedian) {
  const SizeTarget target = SizeTarget::kuz_ram(0.26, 1.39);
  EXPECT_DOUBLE_EQ(target.passing(0.26), 0.5);
  // 1 - 2^-(0.1/0.26)^1.39 = 1 - 2^-0.264920 = 0.167782 (physics dossier: 0.17)
  EXPECT_NEAR(target.passing(0.1), 0.167782, 1e-5);
  EXPECT_EQ(target.passing(0.0), 0.0);
}

TEST(SizeTarget, SwebrecEndsAtItsLargestSize) {
  const SizeTarget target = SizeTarget::swebrec(0.26, 3.0, 4.7);
  EXPECT_DOUBLE_EQ(target.passing(0.26), 0.5);
  EXPECT_EQ(target.passing(3.0), 1.0);
  // ln 6 / ln 11.53846 = 0.732654; ^4.7 = 0.231793; 1/1.231793 = 0.811825 (dossier: 0.81)
  EXPECT_NEAR(target.passing(0.5), 0.811825, 1e-4);
}

TEST(SizeTarget, SizeAtUndoesPassing) {
  for (const SizeTarget& target :
       {SizeTarget::kuz_ram(0.3, 1.2), SizeTarget::swebrec(0.3, 2.0, 3.0)}) {
    for (const double share : {0.02, 0.2, 0.5, 0.8, 0.99}) {
      EXPECT_NEAR(target.passing(target.size_at(share)), share, 1e-12);
    }
  }
}

TEST(SizeTarget, RefusesCurvesThatAreNone) {
  EXPECT_THROW((void)SizeTarget::kuz_ram(0.0, 1.0), InputError);
  EXPECT_THROW((void)SizeTarget::kuz_ram(0.3, 0.0), InputError);
  EXPECT_THROW((void)SizeTarget::swebrec(0.3, 0.3, 2.0), InputError);
  TessellationOptions options = rock();
  options.holes.clear();
  EXPECT_THROW((void)tessellate_to_target(options, SizeTarget::kuz_ram(0.3, 2.0), kLimits),
               InputError);
}

TEST(SizeTarget, ComparisonCountsMassNotNumber) {
  Block small, large;
  small.mass.volume = 0.001;  // size 0.1
  large.mass.volume = 0.027;  // size 0.3
  const std::vector<Block> blocks{small, large};
  const SizeComparison c =
      compare_sizes(blocks, SizeTarget::kuz_ram(0.3, 2.0), {.smallest = 0.05, .largest = 1.0});
  EXPECT_DOUBLE_EQ(c.at(50).achieved, 0.3);
  // just below 0.3 m: achieved 1/28 = 0.0357, target 0.5; at 0.3 m: 1 against 0.5
  EXPECT_NEAR(c.greatest_difference, 0.5, 1e-12);
  EXPECT_FALSE(c.good());
}

void expect_good(const SizeTarget& target, const char* name) {
  const FittedCut fitted = tessellate_to_target(rock(), target, kLimits);
  for (const int percent : {20, 50, 80}) {
    const auto& point = fitted.comparison.at(percent);
    EXPECT_NEAR(point.achieved / point.target, 1.0, 0.05) << name << " P" << percent;
  }
  EXPECT_LT(fitted.comparison.greatest_difference, 0.03) << name;
  double volume = 0.0;
  for (const Block& block : fitted.cut.blocks) volume += block.mass.volume;
  EXPECT_NEAR(volume, 32.0 - M_PI * 0.12 * 0.12 * 1.6, 0.001 * 32.0);
  std::printf("%s: %zu blocks, %d rounds, difference %.4f, P20 %.4f P50 %.4f P80 %.4f\n", name,
              fitted.cut.blocks.size(), fitted.rounds, fitted.comparison.greatest_difference,
              fitted.comparison.at(20).achieved, fitted.comparison.at(50).achieved,
              fitted.comparison.at(80).achieved);
}

TEST(SizeTarget, ACutFollowsKuzRam) { expect_good(SizeTarget::kuz_ram(0.3, 2.5), "kuz_ram"); }

TEST(SizeTarget, ACutFollowsSwebrec) { expect_good(SizeTarget::swebrec(0.3, 1.2, 6.0), "swebrec"); }

TEST(SizeTarget, AMissSaysWhy) {
  TessellationOptions small = rock();
  small.hi = {2.0, -1.0, 1.0};  // 4 m3: a block of P90, 0.53 m, is 4 % of it
  small.holes = {{{0.2, -1.5, 0.2}, {0.2, -1.5, 0.8}, 0.12}};
  const SizeTarget target = SizeTarget::kuz_ram(0.3, 2.1);
  const FittedCut few = tessellate_to_target(small, target, kLimits, 2);
  EXPECT_FALSE(few.comparison.good());
  EXPECT_EQ(few.why_missed,  // 1 - 2^-(0.08/0.3)^2.1 = 0.042
            "4.2 % of the target is finer than block_min; the rock is small: one block of the "
            "target's P90 is 3.8 % of its mass");
  const SizeLimits narrow{0.2, 0.4};
  const FittedCut cropped = tessellate_to_target(rock(), target, narrow, 1);
  // 1 - 2^-(0.2/0.3)^2.1 = 0.256; 2^-(0.4/0.3)^2.1 = 0.281
  EXPECT_EQ(cropped.why_missed,
            "25.6 % of the target is finer than block_min; 28.1 % of the target is coarser than "
            "block_max");
}

}  // namespace
}  // namespace muckpile
