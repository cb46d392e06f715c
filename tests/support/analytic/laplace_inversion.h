// SPDX-License-Identifier: GPL-2.0-or-later
// Numerical inverse of a Laplace transform.
// Scope: transforms analytic off the left half plane and smooth originals for t > 0, as in wave
// problems counted from the arrival.
#pragma once

#include <array>
#include <complex>

namespace muckpile {

/// Fixed Talbot contour (Abate and Valko 2004, eqs. 2 to 5): f(t) = sum of Re(weight F(s)) over the
/// nodes. The error is about 1e-10 of the largest |f|; an oscillation is resolved while
/// (angular frequency) t < 12, or if it has died out by then.
struct TalbotNode {
  std::complex<double> s;       ///< [1/s]
  std::complex<double> weight;  ///< [1/s]
};
inline constexpr int kTalbotNodes = 32;

/// The nodes for a time t > 0 [s]; weights that do not matter are 0. std::domain_error unless t >
/// 0.
[[nodiscard]] std::array<TalbotNode, kTalbotNodes> talbot_nodes(double t);

/// f(t) of a transform F, a callable on std::complex<double>.
template <typename Transform>
[[nodiscard]] double inverse_laplace(const Transform& transform, double t) {
  double sum = 0.0;
  for (const TalbotNode& node : talbot_nodes(t)) {
    if (node.weight != 0.0) sum += (node.weight * transform(node.s)).real();
  }
  return sum;
}

}  // namespace muckpile
