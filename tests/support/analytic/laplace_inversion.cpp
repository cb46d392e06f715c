// SPDX-License-Identifier: GPL-2.0-or-later
// Fixed Talbot inversion (Abate and Valko 2004, Int. J. Numer. Meth. Engng 60:979-993).
#include "analytic/laplace_inversion.h"

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace muckpile {

std::array<TalbotNode, kTalbotNodes> talbot_nodes(double t) {
  if (!(t > 0.0)) throw std::domain_error("talbot_nodes: t must be > 0");
  constexpr double kNegligible = -60.0;  // exp(-60) = 1e-26
  // Truncation falls as 10^(-0.6 n), rounding grows as exp(0.4 n): n = 32 balances in double
  // precision.
  const double r = 0.4 * kTalbotNodes / t;
  std::array<TalbotNode, kTalbotNodes> nodes{};
  nodes[0] = {r, 0.5 * r / kTalbotNodes * std::exp(r * t)};
  for (int k = 1; k < kTalbotNodes; ++k) {
    const double theta = k * std::numbers::pi / kTalbotNodes;
    const double cotangent = 1.0 / std::tan(theta);
    const std::complex<double> s = r * theta * std::complex<double>(cotangent, 1.0);
    if (s.real() * t < kNegligible) break;
    const double sigma = theta + (theta * cotangent - 1.0) * cotangent;
    nodes[static_cast<std::size_t>(k)] = {
        s, r / kTalbotNodes * std::exp(s * t) * std::complex<double>(1.0, sigma)};
  }
  return nodes;
}

}  // namespace muckpile
