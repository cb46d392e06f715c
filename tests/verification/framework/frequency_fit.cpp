// SPDX-License-Identifier: GPL-2.0-or-later
// The frequency of a vibration from samples of it.
// Scope: see the header.
#include "framework/frequency_fit.h"

#include <Eigen/Dense>
#include <cmath>

namespace muckpile::verification {
namespace {

/// Least-squares misfit of a cos(wt) + b sin(wt), solved for a and b.
double misfit(const std::vector<Sample>& samples, double w) {
  Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
  Eigen::Vector2d right = Eigen::Vector2d::Zero();
  double square = 0.0;
  for (const Sample& s : samples) {
    const Eigen::Vector2d basis(std::cos(w * s.time), std::sin(w * s.time));
    normal += basis * basis.transpose();
    right += s.amplitude * basis;
    square += s.amplitude * s.amplitude;
  }
  return square - right.dot(normal.inverse() * right);
}

}  // namespace

double fitted_frequency(const std::vector<Sample>& samples, double low, double high) {
  // Golden section.
  const double golden = 0.5 * (std::sqrt(5.0) - 1.0);
  double a = high - golden * (high - low), b = low + golden * (high - low);
  double at_a = misfit(samples, a), at_b = misfit(samples, b);
  while (high - low > 1e-7 * high) {
    if (at_a < at_b) {
      high = b;
      b = a;
      at_b = at_a;
      a = high - golden * (high - low);
      at_a = misfit(samples, a);
    } else {
      low = a;
      a = b;
      at_a = at_b;
      b = low + golden * (high - low);
      at_b = misfit(samples, b);
    }
  }
  return 0.5 * (low + high);
}

}  // namespace muckpile::verification
