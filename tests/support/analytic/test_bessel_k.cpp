// SPDX-License-Identifier: GPL-2.0-or-later
// Complex K0 and K1 against the standard library on the axes, and identities off them.
// Scope: every branch of the implementation and both sides of each border between them.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "analytic/bessel_k.h"
#include "analytic/laplace_inversion.h"

namespace muckpile {
namespace {

using Complex = std::complex<double>;
constexpr double kPi = std::numbers::pi;
constexpr double kTolerance =
    1e-11;  // the standard library's own functions are good to about 1e-12

TEST(BesselK, MatchesTheStandardLibraryOnThePositiveAxis) {
  for (const double x : {1e-6, 0.01, 0.5, 1.99, 2.01, 5.0, 10.0, 17.99, 18.01, 60.0, 300.0}) {
    const ScaledBesselK k = scaled_bessel_k(x);
    EXPECT_NEAR(k.k0.real() / (std::exp(x) * std::cyl_bessel_k(0.0, x)), 1.0, kTolerance) << x;
    EXPECT_NEAR(k.k1.real() / (std::exp(x) * std::cyl_bessel_k(1.0, x)), 1.0, kTolerance) << x;
    EXPECT_EQ(k.k0.imag(), 0.0);
  }
}

TEST(BesselK, IsAHankelFunctionOnTheImaginaryAxis) {
  // K_n(iy) = (pi/2) (-i)^(n+1) (J_n(y) - i Y_n(y)), DLMF 10.27.8
  for (const double y : {0.3, 1.9, 2.1, 7.0, 17.5, 18.5, 40.0}) {
    const ScaledBesselK k = scaled_bessel_k(Complex(0.0, y));
    const Complex phase = std::exp(Complex(0.0, y));
    const Complex h0(std::cyl_bessel_j(0.0, y), -std::cyl_neumann(0.0, y));
    const Complex h1(std::cyl_bessel_j(1.0, y), -std::cyl_neumann(1.0, y));
    const Complex k0 = Complex(0.0, -0.5 * kPi) * h0 * phase;
    const Complex k1 = -0.5 * kPi * h1 * phase;
    EXPECT_LT(std::abs(k.k0 / k0 - 1.0), kTolerance) << y;
    EXPECT_LT(std::abs(k.k1 / k1 - 1.0), kTolerance) << y;
  }
}

TEST(BesselK, OnTheCutTheImaginaryPartIsBesselI) {
  // K0(-x) = K0(x) - i pi I0(x) and K1(-x) = -K1(x) - i pi I1(x) on the upper side
  for (const double x : {0.5, 1.9, 2.1, 6.0, 17.9}) {
    const ScaledBesselK k = scaled_bessel_k(Complex(-x, 0.0));
    const double scale = std::exp(-x);
    const Complex k0(std::cyl_bessel_k(0.0, x), -kPi * std::cyl_bessel_i(0.0, x));
    const Complex k1(-std::cyl_bessel_k(1.0, x), -kPi * std::cyl_bessel_i(1.0, x));
    EXPECT_LT(std::abs(k.k0 / (scale * k0) - 1.0), kTolerance) << x;
    EXPECT_LT(std::abs(k.k1 / (scale * k1) - 1.0), kTolerance) << x;
  }
}

TEST(BesselK, DerivativeOfK0IsMinusK1InEveryDirection) {
  constexpr double kStep =
      1e-3;  // fourth-order difference: error about h^4 |K|/30 = 3e-14, rounding 1e-12
  const auto k0 = [](Complex z) { return std::exp(-z) * scaled_bessel_k(z).k0; };
  for (const double size : {1.0, 1.9999, 2.0001, 4.0, 10.0, 17.9999, 18.0001, 30.0}) {
    for (int i = -10; i <= 10; ++i) {
      const Complex z = std::polar(size, 0.3 * i);  // up to 172 degrees on either side
      const Complex slope =
          (8.0 * (k0(z + kStep) - k0(z - kStep)) - (k0(z + 2.0 * kStep) - k0(z - 2.0 * kStep))) /
          (12.0 * kStep);
      const Complex k1 = std::exp(-z) * scaled_bessel_k(z).k1;
      EXPECT_LT(std::abs(slope / k1 + 1.0), 1e-9) << z;
    }
  }
}

TEST(BesselK, RefusesTheOrigin) { EXPECT_THROW((void)scaled_bessel_k(0.0), std::domain_error); }

TEST(InverseLaplace, RecoversKnownOriginals) {
  constexpr double kError = 1e-9;  // 1e-10 of the largest value, times 10
  for (const double t : {0.01, 0.3, 1.0, 5.0, 10.0}) {
    EXPECT_NEAR(inverse_laplace([](Complex s) { return 1.0 / s; }, t), 1.0, kError);
    EXPECT_NEAR(inverse_laplace([](Complex s) { return 1.0 / ((s + 1.0) * (s + 1.0)); }, t),
                t * std::exp(-t), kError);
    EXPECT_NEAR(inverse_laplace([](Complex s) { return 1.0 / (s * s + 1.0); }, t), std::sin(t),
                kError);
    // K0(s) e^s is the transform of 1/sqrt(t^2 + 2t)
    EXPECT_NEAR(inverse_laplace([](Complex s) { return scaled_bessel_k(s).k0; }, t) *
                    std::sqrt(t * t + 2.0 * t),
                1.0, kError);
  }
}

}  // namespace
}  // namespace muckpile
