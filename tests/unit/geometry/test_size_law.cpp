// SPDX-License-Identifier: GPL-2.0-or-later
// Size laws against hand-worked numbers, their limits, and every message of the table reader.
// Scope: lengths in metres.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <sstream>

#include "geometry/cut/ground.h"
#include "geometry/size/size_law.h"
#include "input_error_of.h"

namespace muckpile {
namespace {

const SizeLimits kWide{1e-3, 1e3};
constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::string table_message(const std::string& text) {
  return input_error_of([&] {
    std::istringstream in(text);
    (void)read_size_table(in, "sizes.txt");
  });
}

TEST(SizeLaw, HarriesGivesTheSpacingOfRadialCracks) {
  // K/T = 4.8e-3/3e-4 = 16 cracks at the wall b = 0.135 m; at r = 0.5 m: 16*0.135/0.5 = 4.32;
  // spacing 2 pi 0.5 / 4.32 = 0.72722 m.
  const SizeLaw law = SizeLaw::harries({0.135, 4.8e-3, 3e-4, 0.0}, kWide);
  EXPECT_NEAR(law.at(0.5), 2.0 * std::numbers::pi * 0.5 / 4.32, 1e-12);
  EXPECT_NEAR(law.at(0.5), 0.72722, 1e-5);
  EXPECT_NEAR(law.at(1.0) / law.at(0.5), 4.0, 1e-12);  // r^2 without absorption
}

TEST(SizeLaw, HarriesAbsorptionThinsTheCracksOut) {
  const SizeLaw plain = SizeLaw::harries({0.1, 4e-3, 4e-4, 0.0}, kWide);
  const SizeLaw damped = SizeLaw::harries({0.1, 4e-3, 4e-4, 0.05}, kWide);
  EXPECT_NEAR(damped.at(1.0) / plain.at(1.0), std::exp(0.5), 1e-12);  // alpha r / b = 0.05 * 10
}

TEST(SizeLaw, PowerFollowsCoefficientAndExponent) {
  const SizeLaw law = SizeLaw::power({0.145, 2.0}, {0.05, 1.2});
  EXPECT_NEAR(law.at(1.5), 0.32625, 1e-12);  // 0.145 * 2.25
}

TEST(SizeLaw, IsClippedAtBothEndsAndAtInfinity) {
  for (const SizeLaw& law : {SizeLaw::power({0.145, 2.0}, {0.05, 1.2}),
                             SizeLaw::harries({0.135, 4.8e-3, 3e-4, 0.02}, {0.05, 1.2}),
                             SizeLaw::table({{0.0, 0.01}, {9.0, 5.0}}, {0.05, 1.2})}) {
    EXPECT_EQ(law.at(0.0), 0.05);
    EXPECT_EQ(law.at(100.0), 1.2);
    EXPECT_EQ(law.at(kInfinity), 1.2);
  }
}

TEST(SizeLaw, UniformIsTheSameEverywhere) {
  const SizeLaw law = SizeLaw::uniform(0.3);
  EXPECT_EQ(law.at(0.0), 0.3);
  EXPECT_EQ(law.at(kInfinity), 0.3);
}

TEST(SizeLaw, TableInterpolatesLinearlyAndIsConstantBeyondItsEnds) {
  const SizeLaw law = SizeLaw::table({{0.2, 0.1}, {1.2, 0.3}, {2.2, 0.9}}, kWide);
  EXPECT_NEAR(law.at(0.7), 0.2, 1e-15);
  EXPECT_NEAR(law.at(1.7), 0.6, 1e-15);
  EXPECT_EQ(law.at(1.2), 0.3);
  EXPECT_EQ(law.at(0.0), 0.1);
  EXPECT_EQ(law.at(5.0), 0.9);
}

TEST(SizeLaw, BandsHaveOneSizeEachAndTheLastGoesOn) {
  const SizeLaw law = SizeLaw::bands({{{0.5, 0.1}, {1.0, 0.2}, {2.0, 0.4}}}, kWide);
  EXPECT_EQ(law.at(0.0), 0.1);
  EXPECT_EQ(law.at(0.5), 0.1);
  EXPECT_EQ(law.at(0.5001), 0.2);
  EXPECT_EQ(law.at(1.9), 0.4);
  EXPECT_EQ(law.at(kInfinity), 0.4);
}

TEST(SizeLaw, RejectsWhatHasNoMeaning) {
  EXPECT_EQ(input_error_of([] {
              (void)SizeLaw::bands({{{1.0, 0.2}, {2.0, 0.1}}}, kWide);
            }),
            "size law: bands sizes must not fall with distance, got '0.1'");
  EXPECT_THROW((void)SizeLaw::uniform(0.0), InputError);
  EXPECT_THROW((void)SizeLaw::uniform(std::nan("")), InputError);
  EXPECT_THROW((void)SizeLaw::power({0.1, -1.0}, kWide), InputError);
  EXPECT_THROW((void)SizeLaw::power({0.0, 1.0}, kWide), InputError);
  EXPECT_THROW((void)SizeLaw::power({0.1, 1.0}, {0.5, 0.4}), InputError);
  EXPECT_THROW((void)SizeLaw::power({0.1, 1.0}, {0.5, kInfinity}), InputError);
  EXPECT_THROW((void)SizeLaw::harries({0.0, 4e-3, 3e-4, 0.0}, kWide), InputError);
  EXPECT_THROW((void)SizeLaw::harries({0.1, 1e-4, 3e-4, 0.0}, kWide), InputError);
  EXPECT_THROW((void)SizeLaw::harries({0.1, 4e-3, 3e-4, -0.1}, kWide), InputError);
  EXPECT_THROW((void)SizeLaw::table({}, kWide), InputError);
  EXPECT_THROW((void)SizeLaw::table({{1.0, 0.1}, {0.5, 0.2}}, kWide), InputError);
  EXPECT_THROW((void)SizeLaw::table({{0.5, 0.2}, {1.0, 0.1}}, kWide), InputError);
  EXPECT_EQ(input_error_of([] {
              (void)SizeLaw::power({0.1, 1.0}, {0.5, 0.4});
            }),
            "size law: largest block must be >= smallest block (0.5 m), got '0.4'");
}

TEST(SizeTableReader, ReadsPairsAndSkipsCommentsAndBlankLines) {
  std::istringstream in("# distance_m size_m\n\n0.2 0.1  # ring\n 1.5\t4e-1\n");
  const SizeTable points = read_size_table(in, "sizes.txt");
  ASSERT_EQ(points.size(), 2u);
  EXPECT_EQ(points[0], std::pair(0.2, 0.1));
  EXPECT_EQ(points[1], std::pair(1.5, 0.4));
}

TEST(SizeTableReader, NamesFileAndLineOfAFault) {
  EXPECT_EQ(table_message("0.2 0.1\n0.5 x1\n"),
            "size table 'sizes.txt' line 2: a finite number is expected, got 'x1'");
  EXPECT_EQ(table_message("0.2 0.1m\n"),
            "size table 'sizes.txt' line 1: a finite number is expected, got '0.1m'");
  EXPECT_EQ(table_message("0.2 nan\n"),
            "size table 'sizes.txt' line 1: a finite number is expected, got 'nan'");
  EXPECT_EQ(table_message("0.2\n"),
            "size table 'sizes.txt' line 1: two numbers are expected: distance [m] and size [m], "
            "got '0.2'");
  EXPECT_EQ(table_message("\n0.2 0.1 0.3\n"),
            "size table 'sizes.txt' line 2: two numbers are expected: distance [m] and size [m], "
            "got '0.2 0.1 0.3'");
  EXPECT_EQ(table_message("-1 0.1\n"),
            "size table 'sizes.txt' line 1: distance must be >= 0 m, got '-1'");
  EXPECT_EQ(table_message("1 0\n"), "size table 'sizes.txt' line 1: size must be > 0 m, got '0'");
  EXPECT_EQ(table_message("1 0.1\n1 0.2\n"),
            "size table 'sizes.txt' line 2: distance must grow from line to line, got '1'");
  EXPECT_EQ(table_message("1 0.2\n2 0.1\n"),
            "size table 'sizes.txt' line 2: size must not fall with distance, got '0.1'");
  EXPECT_EQ(table_message("# nothing\n"), "size table 'sizes.txt': no pairs found");
  EXPECT_EQ(input_error_of([] { (void)read_size_table_file("no_such_file.txt"); }),
            "size table 'no_such_file.txt': cannot be opened");
}

// Strain 227 MPa / (2 x 24 GPa) = 4.729e-3 on r1 = 0.135 m, breaking strain 3e-4, no absorption.
constexpr HarriesParameters kRing{
    .hole_radius = 0.135, .wall_strain = 4.729e-3, .breaking_strain = 3e-4, .absorption = 0.0};

TEST(Harries, CountsRadialCracksAndTheirSpacing) {
  EXPECT_NEAR(harries_cracks(kRing, 0.135), 15.763, 1e-3);  // 4.729e-3/3e-4
  EXPECT_NEAR(harries_cracks(kRing, 0.5), 4.256, 1e-3);     // 15.763 x 0.27
  EXPECT_NEAR(harries_spacing(kRing, 0.5), 0.7381, 1e-3);   // 2 pi 0.5/4.256
  EXPECT_NEAR(harries_spacing(kRing, 1.0) / harries_spacing(kRing, 0.5), 4.0, 1e-12);  // r^2
  EXPECT_NEAR(harries_reach(kRing), 2.128, 1e-3);  // 0.135 x 15.763
}

TEST(Harries, AbsorptionEndsTheCracksEarlier) {
  HarriesParameters damped = kRing;
  damped.absorption = 0.05;
  const double reach = harries_reach(damped);
  EXPECT_LT(reach, harries_reach(kRing));
  EXPECT_NEAR(harries_cracks(damped, reach), 1.0, 1e-9);
}

TEST(Harries, CracksOfTwoChargesAddUpAndTheLimitsHold) {
  const SizeLaw law = SizeLaw::harries(kRing, {.smallest = 0.1, .largest = 10.0});
  const std::vector<double> apart{1.0, 1.0}, far{1.0, 1e6}, near{0.135, 0.135};
  EXPECT_NEAR(law.superposed(apart), 0.5 * law.at(1.0), 1e-12);
  EXPECT_NEAR(law.superposed(far), law.at(1.0), 1e-9);
  EXPECT_EQ(law.superposed(near), 0.1);
}

TEST(Harries, SuperposedRockIsFinerBetweenTwoHoles) {
  TessellationOptions options;
  options.lo = {-1.5, -0.5, 0.0};
  options.hi = {1.5, 0.5, 0.5};
  options.holes = {{{-1.0, 0, 0.1}, {-1.0, 0, 0.4}, 0.135}, {{1.0, 0, 0.1}, {1.0, 0, 0.4}, 0.135}};
  options.size = SizeLaw::harries(kRing, {.smallest = 0.15, .largest = 5.0});
  const double alone = expected_block_count(options, 1e9);
  const Vec3 between(0.0, 0.0, 0.25);
  EXPECT_NEAR(Ground(options).size(between), 2.9525, 1e-3);  // 2 pi/(15.763 x 0.135)
  options.superpose = true;
  EXPECT_NEAR(Ground(options).size(between), 0.5 * 2.9525, 1e-3);
  EXPECT_GT(expected_block_count(options, 1e9), alone);
}

TEST(SizeLaw, HarriesWithoutAbsorptionIsTheLargestSizeWhereNoChargeIs) {
  const SizeLaw law = SizeLaw::harries({0.1, 1e-3, 1e-4, 0.0}, {0.2, 1.5});
  EXPECT_EQ(law.at(std::numeric_limits<double>::infinity()), 1.5);
}

}  // namespace
}  // namespace muckpile
