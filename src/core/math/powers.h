// SPDX-License-Identifier: GPL-2.0-or-later
// x^e of many numbers: a loop over it is vectorised, one over std::pow is not.
// Scope: 2.3e-308 <= x (less counts as that) and results from 1e-304 to 1e304; not for NaN.
// Relative error below (4 + |e log x|) 2.2e-16.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>

namespace muckpile {
namespace powers_detail {

inline constexpr int kMantissaBits = 52;

/// c[First] + c[First + 1] z + ...; a loop here would keep the loop around it from being
/// vectorised.
template <std::size_t First = 0, std::size_t N>
[[gnu::always_inline]] inline double polynomial(const double (&c)[N], double z) {
  if constexpr (First + 1 == N)
    return c[First];
  else
    return c[First] + z * polynomial<First + 1>(c, z);
}

/// Natural logarithm: x = 2^n m with m within a factor sqrt(2) of 1, log m = 2 artanh((m-1)/(m+1)).
[[gnu::always_inline]] inline double log_of(double x) {
  // z = ((m-1)/(m+1))^2 <= 0.0295: the next term would be 2e-18.
  constexpr double kSeries[] = {1.0,        1.0 / 3.0,  1.0 / 5.0,  1.0 / 7.0,
                                1.0 / 9.0,  1.0 / 11.0, 1.0 / 13.0, 1.0 / 15.0,
                                1.0 / 17.0, 1.0 / 19.0, 1.0 / 21.0};
  constexpr double kLeast = std::numeric_limits<double>::min();
  const auto bits = std::bit_cast<std::int64_t>(x > kLeast ? x : kLeast);  // std::max: by reference
  const auto half = std::bit_cast<std::int64_t>(1.0 / std::numbers::sqrt2);
  const std::int64_t n = (bits - half) >> kMantissaBits;
  const double m = std::bit_cast<double>(bits - n * (std::int64_t{1} << kMantissaBits));
  const double s = (m - 1.0) / (m + 1.0);
  return static_cast<double>(n) * std::numbers::ln2 + 2.0 * s * polynomial(kSeries, s * s);
}

/// e^y = 2^n e^r with |r| <= log(2)/2.
[[gnu::always_inline]] inline double exp_of(double y) {
  // 1/k!; the next term would be 5e-18.
  constexpr double kSeries[] = {1.0,
                                1.0,
                                1.0 / 2,
                                1.0 / 6,
                                1.0 / 24,
                                1.0 / 120,
                                1.0 / 720,
                                1.0 / 5040,
                                1.0 / 40320,
                                1.0 / 362880,
                                1.0 / 3628800,
                                1.0 / 39916800,
                                1.0 / 479001600,
                                1.0 / 6227020800};
  constexpr double kFarthest = 700.0;  // 1e304
  constexpr std::int64_t kBias = 1023;
  const double above = y > -kFarthest ? y : -kFarthest;
  const double within = above < kFarthest ? above : kFarthest;
  // Added to a small number it leaves that rounded to a whole one in the last bits.
  constexpr double kWhole = 0x1.8p52;
  const double shifted = within * std::numbers::log2e + kWhole, n = shifted - kWhole;
  // log(2) in two parts, the first so short that n times it is exact (Cody and Waite).
  constexpr double kLong = 0x1.62e42fefp-1, kRest = 7.4406171100123967e-11;
  const double r = within - n * kLong - n * kRest;
  const std::int64_t whole =
      std::bit_cast<std::int64_t>(shifted) - std::bit_cast<std::int64_t>(kWhole);
  const double power_of_two =
      std::bit_cast<double>((whole + kBias) * (std::int64_t{1} << kMantissaBits));
  return power_of_two * polynomial(kSeries, r);
}

}  // namespace powers_detail

[[gnu::always_inline]] inline double power_of(double x, double exponent) {
  return powers_detail::exp_of(exponent * powers_detail::log_of(x));
}

/// x^(-1/3), in a third of the time; relative error below 2e-15 from 1e-12 to 1e12.
[[gnu::always_inline]] inline double inverse_cube_root(double x) {
  const auto one = std::bit_cast<std::int64_t>(1.0);
  const std::int64_t above = std::bit_cast<std::int64_t>(x) - one;
  constexpr std::int64_t kLess = std::int64_t{1} << 48;  // errs as much to both sides
  // A third of what the bits are above those of 1, by its binary digits 0.010101...: within 4 %.
  const std::int64_t third = (above >> 2) + (above >> 4) + (above >> 6) + (above >> 8) +
                             (above >> 10) + (above >> 12) + (above >> 14);
  double y = std::bit_cast<double>(one - third - kLess);
  for (int k = 0; k < 4; ++k) y *= 4.0 / 3.0 - (1.0 / 3.0) * x * y * y * y;  // Newton
  return y;
}

}  // namespace muckpile
