// SPDX-License-Identifier: GPL-2.0-or-later
// Downward slopes of a surface: least-squares lines through stretches of its samples.
// Scope: sums are taken about the first sample, so heights far from zero lose no digits.
#include "measure/slope.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace muckpile {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr size_t kFewest = 3;  // samples of a line

class Line {
 public:
  Line(double x0, double z0) : x0_(x0), z0_(z0) {}

  void add(double x, double z) {
    const double dx = x - x0_, dz = z - z0_;
    ++count_, x_ += dx, z_ += dz, xx_ += dx * dx, xz_ += dx * dz;
  }

  [[nodiscard]] double fall() const {
    const auto n = static_cast<double>(count_);
    return count_ < kFewest ? kNan : -(n * xz_ - x_ * z_) / (n * xx_ - x_ * x_);
  }

 private:
  double x0_, z0_;
  size_t count_ = 0;
  double x_ = 0.0, z_ = 0.0, xx_ = 0.0, xz_ = 0.0;
};

}  // namespace

double slope_between_heights(const std::vector<double>& x, const std::vector<double>& z,
                             size_t begin, size_t end, double low, double high) {
  if (begin >= end) return kNan;
  Line line(x[begin], z[begin]);
  for (size_t i = begin; i < end; ++i) {
    if (z[i] >= low && z[i] <= high) line.add(x[i], z[i]);
  }
  return line.fall();
}

double steepest_slope(const std::vector<double>& x, const std::vector<double>& z, size_t begin,
                      size_t end, double stretch) {
  if (begin + kFewest > end) return kNan;
  const auto wanted = static_cast<size_t>(std::lround(stretch / (x[begin + 1] - x[begin])));
  const size_t samples = std::clamp(wanted, kFewest, end - begin);
  double steepest = -std::numeric_limits<double>::infinity();
  for (size_t first = begin; first + samples <= end; ++first) {
    Line line(x[first], z[first]);
    for (size_t i = first; i < first + samples; ++i) line.add(x[i], z[i]);
    steepest = std::max(steepest, line.fall());
  }
  return steepest;
}

}  // namespace muckpile
