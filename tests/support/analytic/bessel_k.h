// SPDX-License-Identifier: GPL-2.0-or-later
// Modified Bessel functions of the second kind of complex argument, orders 0 and 1.
// Scope: double precision, |arg z| <= pi, for Laplace solutions of waves around a cylinder.
#pragma once

#include <complex>

namespace muckpile {

struct ScaledBesselK {
  std::complex<double> k0;  ///< exp(z) K0(z)
  std::complex<double> k1;  ///< exp(z) K1(z)
};

/// exp(z) K0(z) and exp(z) K1(z), principal branch (cut along the negative real axis, the value on
/// it is that of its upper side). Relative error below 1e-12 except where a function is next to a
/// zero. |z| < 2: ascending series (DLMF 10.31.1, 10.31.2); |z| >= 18: asymptotic expansion
/// (10.40.2); between: trapezoid rule on the Gaussian form of (10.32.8), continued to Re z < 0 by
/// (10.34.2). std::domain_error at z = 0.
[[nodiscard]] ScaledBesselK scaled_bessel_k(std::complex<double> z);

}  // namespace muckpile
