// SPDX-License-Identifier: GPL-2.0-or-later
// Powers in vectorised loops against those of the mathematics library.
// Scope: the range that the header promises.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "math/powers.h"

namespace muckpile {
namespace {

TEST(Powers, AreThoseOfTheLibraryToTheRoundingOfTheLogarithm) {
  double worst = 0.0;  // error over (4 + |e log x|) epsilon
  for (const double exponent : {1.4, 1.0 / 1.4, -4.0 / 3.0, 0.5, 2.0}) {
    for (double x = 1e-120; x < 1e120; x *= 1.0137) {
      const double exact = std::pow(x, exponent);
      const double bound =
          (4.0 + std::abs(exponent * std::log(x))) * std::numeric_limits<double>::epsilon();
      worst = std::max(worst, std::abs(power_of(x, exponent) / exact - 1.0) / bound);
    }
  }
  EXPECT_LT(worst, 1.0);
  EXPECT_GT(worst, 0.0);
}

TEST(Powers, OfOneAreOne) {
  for (const double exponent : {-3.0, 0.0, 0.7, 1.4}) EXPECT_EQ(power_of(1.0, exponent), 1.0);
}

TEST(Powers, AreSmoothWhereTheBinaryExponentChanges) {
  // the mantissa is cut at sqrt(1/2) 2^n
  for (int n = -40; n < 40; n += 7) {
    const double cut = std::ldexp(std::sqrt(0.5), n);
    for (const double x : {std::nextafter(cut, 0.0), cut, std::nextafter(cut, 1e30)})
      EXPECT_NEAR(power_of(x, 1.4) / std::pow(x, 1.4), 1.0, 1e-14) << x;
  }
}

TEST(Powers, InverseCubeRootsAreThoseOfTheLibrary) {
  double worst = 0.0;
  for (double x = 1e-12; x < 1e12; x *= 1.00137)
    worst = std::max(worst, std::abs(inverse_cube_root(x) * std::cbrt(x) - 1.0));
  EXPECT_LT(worst, 2e-15);
  EXPECT_GT(worst, 0.0);
}

TEST(Powers, StayFiniteBeyondTheirRange) {
  EXPECT_TRUE(std::isfinite(power_of(0.0, 1.4)));
  EXPECT_LT(power_of(0.0, 1.4), 1e-300);
  EXPECT_TRUE(std::isfinite(power_of(1e308, 2.0)));
}

}  // namespace
}  // namespace muckpile
