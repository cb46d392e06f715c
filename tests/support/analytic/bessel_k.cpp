// SPDX-License-Identifier: GPL-2.0-or-later
// K0 and K1 of complex argument; DLMF = NIST Digital Library of Mathematical Functions.
#include "analytic/bessel_k.h"

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace muckpile {
namespace {

using Complex = std::complex<double>;
constexpr double kPi = std::numbers::pi;
constexpr Complex kI(0.0, 1.0);

/// DLMF 10.31.1 and 10.31.2 with 10.25.2; q = z^2/4.
ScaledBesselK ascending_series(Complex z) {
  const Complex q = 0.25 * z * z;
  const Complex log_half = std::log(0.5 * z);
  double psi = -std::numbers::egamma;  // digamma(k + 1)
  Complex term0 = 1.0;                 // q^k / k!^2
  Complex term1 = 0.5 * z;             // (z/2) q^k / (k! (k+1)!)
  Complex k0 = 0.0;
  Complex k1 = 1.0 / z;
  constexpr int kTerms = 25;  // (|z|/2)^50 / 25!^2 < 1e-50 for |z| <= 2
  for (int k = 0; k < kTerms; ++k) {
    const double next_psi = psi + 1.0 / (k + 1);
    k0 += term0 * (psi - log_half);
    k1 += term1 * (log_half - 0.5 * (psi + next_psi));
    psi = next_psi;
    term0 *= q / (1.0 * (k + 1) * (k + 1));
    term1 *= q / (1.0 * (k + 1) * (k + 2));
  }
  const Complex scale = std::exp(z);
  return {scale * k0, scale * k1};
}

/// sqrt(pi/2z) sum a_k(nu)/z^k up to the smallest term, DLMF 10.40.2 and 10.17.1.
Complex asymptotic_expansion(Complex z, double nu) {
  Complex sum = 1.0;
  Complex term = 1.0;
  double last = 1.0;
  constexpr int kMaximumTerms = 60;
  for (int k = 1; k < kMaximumTerms; ++k) {
    const double odd = 2.0 * k - 1.0;
    term *= (4.0 * nu * nu - odd * odd) / (8.0 * k * z);
    const double size = std::abs(term);
    if (size >= last || size < 1e-17) break;
    sum += term;
    last = size;
  }
  return std::sqrt(kPi / (2.0 * z)) * sum;
}

/// DLMF 10.32.8 after t = 1 + x^2/z, Re z >= 0: an integral of exp(-x^2) over a function whose
/// singularities +-i sqrt(2z) keep sqrt|z| from the axis, so the trapezoid error is exp(-2 pi
/// sqrt|z|/h).
ScaledBesselK gaussian_integral(Complex z) {
  constexpr double kStep = 0.125;  // exp(-2 pi sqrt 2 / 0.125) = 1e-31
  constexpr int kNodes = 50;       // exp(-6.25^2) = 1e-17
  Complex sum0 = 0.5;
  Complex sum1 = 0.0;
  for (int i = 1; i <= kNodes; ++i) {
    const double x2 = kStep * i * kStep * i;
    const Complex root = std::sqrt(1.0 + x2 / (2.0 * z));
    sum0 += std::exp(-x2) / root;
    sum1 += std::exp(-x2) * x2 * root;
  }
  const Complex scale = std::sqrt(kPi / (2.0 * z)) * (2.0 * kStep / std::sqrt(kPi));
  return {scale * sum0, 2.0 * scale * sum1};
}

struct BesselI {
  Complex i0, i1;
};

/// exp(-w) I0(w), exp(-w) I1(w), DLMF 10.32.3, by the trapezoid rule, whose error is about
/// I_128(|w|) < 1e-90 for |w| <= 18.
BesselI scaled_bessel_i(Complex w) {
  constexpr int kIntervals = 64;
  BesselI sum{0.0, 0.0};
  for (int j = 0; j <= kIntervals; ++j) {
    const double cosine = std::cos(kPi * j / kIntervals);
    const double weight = (j == 0 || j == kIntervals ? 0.5 : 1.0) / kIntervals;
    const Complex value = weight * std::exp(w * (cosine - 1.0));
    sum.i0 += value;
    sum.i1 += cosine * value;
  }
  return sum;
}

/// DLMF 10.34.2 with m = +-1: from w = -z in the right half plane.
ScaledBesselK continued_to_left(Complex z) {
  const Complex w = -z;
  const ScaledBesselK k = gaussian_integral(w);
  const BesselI i = scaled_bessel_i(w);
  const Complex turn = (std::signbit(z.imag()) ? -1.0 : 1.0) * kPi * kI;  // pi i m
  const Complex decay = std::exp(-2.0 * w);  // exp(z) K(w) from exp(w) K(w)
  return {decay * k.k0 - turn * i.i0, -decay * k.k1 - turn * i.i1};
}

}  // namespace

ScaledBesselK scaled_bessel_k(Complex z) {
  const double size = std::abs(z);
  if (!(size > 0.0)) throw std::domain_error("scaled_bessel_k: z must not be 0");
  if (size < 2.0) return ascending_series(z);
  if (size >= 18.0) return {asymptotic_expansion(z, 0.0), asymptotic_expansion(z, 1.0)};
  return z.real() >= 0.0 ? gaussian_integral(z) : continued_to_left(z);
}

}  // namespace muckpile
