// SPDX-License-Identifier: GPL-2.0-or-later
// A power law fitted to points, with its confidence.
// Scope: see the header.
#include "measure/power_fit.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace muckpile {
namespace {

// Probability that |T| <= t: Abramowitz & Stegun 1964, 26.7.3 and 26.7.4.
double within(double t, size_t freedom) {
  const double angle = std::atan(t / std::sqrt(static_cast<double>(freedom)));
  const double cosine = std::cos(angle), sine = std::sin(angle);
  const bool odd = freedom % 2 == 1;
  double term = odd ? cosine : 1.0, sum = freedom == 1 ? 0.0 : term;
  for (size_t k = odd ? 3 : 2; k < freedom; k += 2) {
    const double order = static_cast<double>(k);
    term *= cosine * cosine * (order - 1.0) / order;
    sum += term;
  }
  return odd ? 2.0 / std::numbers::pi * (angle + sine * sum) : sine * sum;
}

struct Logarithms {
  explicit Logarithms(const std::vector<Vec2>& points) : count(static_cast<double>(points.size())) {
    for (const Vec2& p : points) {
      mean_x += std::log10(p.x()) / count;
      mean_y += std::log10(p.y()) / count;
    }
    for (const Vec2& p : points) {
      const double x = std::log10(p.x()) - mean_x, y = std::log10(p.y()) - mean_y;
      xx += x * x;
      xy += x * y;
      yy += y * y;
    }
  }
  double count, mean_x = 0.0, mean_y = 0.0, xx = 0.0, xy = 0.0, yy = 0.0;
};

Interval powers(double middle, double reach) {
  return {std::pow(10.0, middle - reach), std::pow(10.0, middle + reach)};
}

}  // namespace

double PowerFit::at(double x) const { return factor * std::pow(x, -exponent); }

Interval PowerFit::band(double x) const {
  const double off = std::log10(x) - mean_x;
  const double share = 1.0 + 1.0 / static_cast<double>(points) + off * off / spread_x;
  return powers(std::log10(at(x)), student * scatter * std::sqrt(share));
}

double student_two_sided_95(size_t degrees_of_freedom) {
  double low = 0.0, high = 20.0;  // 12.7 for one degree of freedom
  for (int k = 0; k < 60; ++k) {
    const double middle = 0.5 * (low + high);
    (within(middle, degrees_of_freedom) < 0.95 ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

std::optional<PowerFit> fit_decay_law(const std::vector<Vec2>& points) {
  constexpr double kOnePlace = 1e-12;
  if (points.size() < 3) return std::nullopt;
  const Logarithms logs(points);
  if (logs.xx < kOnePlace) return std::nullopt;
  const double slope = logs.xy / logs.xx, start = logs.mean_y - slope * logs.mean_x;
  const double left = std::max(logs.yy - slope * logs.xy, 0.0);  // rounding
  const double t = student_two_sided_95(points.size() - 2);
  const double scatter = std::sqrt(left / (logs.count - 2.0));
  const double of_slope = t * scatter / std::sqrt(logs.xx);
  const double of_start =
      t * scatter * std::sqrt(1.0 / logs.count + logs.mean_x * logs.mean_x / logs.xx);
  PowerFit fit{};
  fit.factor = std::pow(10.0, start);
  fit.exponent = -slope;
  fit.factor_range = powers(start, of_start);
  fit.exponent_range = {-slope - of_slope, -slope + of_slope};
  fit.r_squared = logs.yy > 0.0 ? 1.0 - left / logs.yy : 1.0;
  fit.points = points.size();
  fit.student = t;
  fit.scatter = scatter;
  fit.mean_x = logs.mean_x;
  fit.spread_x = logs.xx;
  return fit;
}

}  // namespace muckpile
