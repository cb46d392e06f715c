// SPDX-License-Identifier: GPL-2.0-or-later
// A power law fitted to points, with its confidence.
// Scope: least squares in the logarithms, the residuals taken as normal there and independent.
#pragma once

#include <optional>
#include <vector>

#include "measure/scan_polygon.h"

namespace muckpile {

struct Interval {
  double low, high;
};

// y = K x^-n.
struct PowerFit {
  double factor;            // K, in the unit of y
  double exponent;          // n
  Interval factor_range;    // 95 % confidence
  Interval exponent_range;  // 95 % confidence
  double r_squared;         // of the logarithms
  size_t points;

  [[nodiscard]] double at(double x) const;
  // In which a further point at x lies with 95 % probability.
  [[nodiscard]] Interval band(double x) const;

  double student;   // t of 95 % confidence
  double scatter;   // deviation of the residuals of log10 y
  double mean_x;    // of log10 x
  double spread_x;  // sum of the squares of log10 x about that
};

// Nothing for fewer than three points or points at one x. All numbers must be > 0.
std::optional<PowerFit> fit_decay_law(const std::vector<Vec2>& points);

// t that a variable of Student's distribution exceeds in magnitude with probability 0.05.
double student_two_sided_95(size_t degrees_of_freedom);

}  // namespace muckpile
