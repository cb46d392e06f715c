// SPDX-License-Identifier: GPL-2.0-or-later
// Sieve sizes of known bodies, fitted size curves and Kuz-Ram against numbers worked by hand.
// Scope: measure/sieve_size, size_fit and kuz_ram.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <random>

#include "args/input_error.h"
#include "measure/kuz_ram.h"
#include "measure/sieve_size.h"
#include "measure/size_fit.h"
#include "synthetic_run.h"

namespace muckpile {
namespace {

using namespace testing;

std::vector<Vec3> box(double a, double b, double c, const Quat& turn = Quat::Identity()) {
  std::vector<Vec3> corners;
  for (int k = 0; k < 8; ++k)
    corners.push_back(turn * Vec3(a * (k & 1), b * ((k >> 1) & 1), c * ((k >> 2) & 1)));
  return corners;
}

std::vector<Vec3> axes_of(const Quat& turn = Quat::Identity()) {
  return {turn * Vec3::UnitX(), turn * Vec3::UnitY(), turn * Vec3::UnitZ()};
}

TEST(SieveSize, OfACubeIsItsEdge) {
  EXPECT_NEAR(sieve_size(as_start_blocks({cube_at({3, 4, 5})})[0]), kCube, 1e-9);
}

TEST(SieveSize, OfABrickIsItsMiddleEdge) {
  EXPECT_NEAR(sieve_size(box(3.0, 1.0, 0.6), axes_of()), 1.0, 1e-9);
  const Quat turn = Quat(0.3, 0.5, -0.4, 0.7).normalized();
  EXPECT_NEAR(sieve_size(box(3.0, 1.0, 0.6, turn), axes_of(turn)), 1.0, 1e-9);
}

// Across the diagonal of the opening: (1 + 0.1)/sqrt(2).
TEST(SieveSize, OfAThinPlateIsLessThanItsWidth) {
  EXPECT_NEAR(sieve_size(box(3.0, 1.0, 0.1), axes_of()), 1.1 / std::sqrt(2.0), 1e-9);
}

// From directions that know nothing of the body: within two hundredths, never less.
TEST(SieveSize, IsFoundFromSpreadDirections) {
  const Quat turn = Quat(0.3, 0.5, -0.4, 0.7).normalized();
  const double found = sieve_size(box(3.0, 1.0, 0.8, turn), spread_directions(200));
  EXPECT_GE(found, 1.0 - 1e-9);
  EXPECT_LE(found, 1.02);
}

TEST(SieveSize, OutermostPointsKeepTheWidths) {
  std::vector<Vec3> ball = spread_directions(5000);
  for (size_t k = 0; k < 5000; ++k) ball.emplace_back(-ball[k]);
  const std::vector<Vec3> outer = outermost(ball, 500);
  EXPECT_LE(outer.size(), 1000U);
  EXPECT_NEAR(sieve_size(outer, spread_directions(20)), 2.0, 0.02);
}

// A curve made of the law itself, 1 % of the mass apart.
std::vector<SizePoint> curve_of(const SizeTarget& target) {
  std::vector<SizePoint> curve;
  for (int k = 1; k < 100; ++k) curve.push_back({target.size_at(0.01 * k), 0.01 * k});
  return curve;
}

TEST(SizeFit, FindsTheRosinRammlerCurveItWasMadeOf) {
  const auto fit = fit_rosin_rammler(curve_of(SizeTarget::kuz_ram(0.4, 1.3)));
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->x50, 0.4, 1e-6);
  EXPECT_NEAR(fit->shape, 1.3, 1e-5);
  EXPECT_LT(fit->rms, 1e-6);
}

TEST(SizeFit, FindsTheSwebrecCurveItWasMadeOf) {
  auto curve = curve_of(SizeTarget::swebrec(0.4, 2.0, 2.5));
  curve.push_back({2.0, 1.0});
  const auto fit = fit_swebrec(curve);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->x50, 0.4, 1e-6);
  EXPECT_NEAR(fit->shape, 2.5, 1e-5);
  EXPECT_DOUBLE_EQ(fit->xmax, 2.0);
  EXPECT_LT(fit->rms, 1e-6);
}

TEST(SizeFit, TellsTheErrorOfTheWrongLaw) {
  auto curve = curve_of(SizeTarget::swebrec(0.4, 1.0, 1.5));
  curve.push_back({1.0, 1.0});
  EXPECT_GT(fit_rosin_rammler(curve)->rms, 0.01);
}

// Curves whose sizes P5 ... P95 are off the law by chance, 0.4 % of the mass as a standard
// deviation: x50 and shape scatter by what each fit says of its own error. The scatter of 400 fits
// is known to 4 %, so 12 % are three times that.
template <class Fit>
void expect_told_errors(const SizeTarget& law, double largest, const Fit& fit) {
  std::mt19937 random(5);
  std::normal_distribution<double> chance(0.0, 0.004);
  double x50[2] = {0.0, 0.0}, shape[2] = {0.0, 0.0}, told_x50 = 0.0, told_shape = 0.0;
  constexpr int kFits = 400;
  for (int k = 0; k < kFits; ++k) {
    std::vector<SizePoint> curve;
    for (int percent = 5; percent < 100; percent += 5)
      curve.push_back({law.size_at(0.01 * percent + chance(random)), 0.01 * percent});
    curve.push_back({largest, 1.0});
    const auto found = fit(curve);
    ASSERT_TRUE(found);
    x50[0] += found->x50 / kFits, x50[1] += found->x50 * found->x50 / kFits;
    shape[0] += found->shape / kFits, shape[1] += found->shape * found->shape / kFits;
    told_x50 += found->x50_error / kFits, told_shape += found->shape_error / kFits;
  }
  const double x50_scatter = std::sqrt(x50[1] - x50[0] * x50[0]);
  const double shape_scatter = std::sqrt(shape[1] - shape[0] * shape[0]);
  std::printf("x50 %.3e told %.3e, shape %.3e told %.3e\n", x50_scatter, told_x50, shape_scatter,
              told_shape);
  EXPECT_NEAR(told_x50 / x50_scatter, 1.0, 0.12);
  EXPECT_NEAR(told_shape / shape_scatter, 1.0, 0.12);
}

TEST(SizeFit, ScattersByTheErrorsItTells) {
  expect_told_errors(SizeTarget::kuz_ram(0.4, 1.3), 2.0, fit_rosin_rammler);
  expect_told_errors(SizeTarget::swebrec(0.4, 2.0, 2.5), 2.0, fit_swebrec);
}

TEST(SizeFit, HasNothingToFitToOneSize) {
  EXPECT_FALSE(fit_rosin_rammler({{0.5, 1.0}}));
  EXPECT_FALSE(fit_swebrec({{0.5, 1.0}}));
  EXPECT_FALSE(fit_rosin_rammler({}));
}

// W 3 m, S 3.45 m, H 15 m, Q 83.8 kg (q 0.54 kg/m3), ANFO, A 7, d 90 mm, L 12 m, deviation 0.1 m:
// 7 x 1.637 x 2.092 x 1.0926 = 26.19 cm; (2.2 - 0.4667) x 1.0368 x 0.9667 x 0.8 = 1.390.
TEST(KuzRam, GivesTheNumbersWorkedByHand) {
  const double burden = 3.0, spacing = 3.45, height = 15.0;
  const double mass = 0.54 * burden * spacing * height;
  const KuzRamCurve curve = kuz_ram({burden, spacing, height, 0.09, 12.0, mass, 100.0, 7.0, 0.1});
  EXPECT_NEAR(curve.x50, 0.2619, 1e-4);
  EXPECT_NEAR(curve.n, 1.390, 1e-3);
  EXPECT_NEAR(curve.curve().passing(0.1), 0.17, 5e-3);
  EXPECT_NEAR(curve.curve().passing(0.5), 0.82, 5e-3);
}

TEST(KuzRam, RefusesWhatItIsNotMadeFor) {
  EXPECT_THROW((void)kuz_ram({9.0, 3.0, 10.0, 0.05, 8.0, 20.0, 100.0, 7.0, 0.0}), InputError);
  EXPECT_THROW((void)kuz_ram({3.0, 3.0, 10.0, 0.05, 8.0, 20.0, 0.0, 7.0, 0.0}), InputError);
}

// 0.06 (50 + 16.25 + 34) of stiff rock, 0.06 (50 + 12.5 + 10) of 30 GPa.
TEST(KuzRam, RockFactorAfterLilly) {
  EXPECT_NEAR(lilly_rock_factor(50.0, 2650.0, 55e9, 170e6), 6.015, 1e-9);
  EXPECT_NEAR(lilly_rock_factor(50.0, 2500.0, 30e9, 170e6), 4.35, 1e-9);
}

}  // namespace
}  // namespace muckpile
