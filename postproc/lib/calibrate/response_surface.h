// SPDX-License-Identifier: GPL-2.0-or-later
// A figure of a run as a polynomial of the uncertain constants, fitted to the runs of a sweep.
// Scope: linear, or quadratic with all products of two; each constant counts by its logarithm, at
// -1 at the least and +1 at the largest value of the sweep.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace muckpile {

// Between a constant and its place on a surface.
struct LogScale {
  double middle, half;  // of the swept range, in ln; half > 0
  [[nodiscard]] double place_of(double value) const;
  [[nodiscard]] double value_at(double place) const;
};

// `values` are positive and hold two different ones at least.
[[nodiscard]] LogScale log_scale(const std::vector<double>& values);

enum class SurfaceOrder { kLinear, kQuadratic };

[[nodiscard]] size_t terms_of(SurfaceOrder order, size_t constants);

class ResponseSurface {
 public:
  // Least squares; a row of `places` per run. Throws InputError, its text beginning with `name`,
  // where there are not more runs than terms, or the runs do not tell the terms apart.
  ResponseSurface(SurfaceOrder order, const Eigen::MatrixXd& places, const Eigen::VectorXd& values,
                  const std::string& name);

  [[nodiscard]] double at(const Eigen::VectorXd& place) const;
  [[nodiscard]] Eigen::VectorXd slope(const Eigen::VectorXd& place) const;  // per unit of place

  // Standard deviation of a run about the surface, by runs less terms: the scatter of seeds and
  // what the figure has of another shape.
  [[nodiscard]] double scatter() const { return scatter_; }
  [[nodiscard]] int spare() const { return spare_; }  // runs less terms

 private:
  SurfaceOrder order_;
  Eigen::VectorXd factors_;
  double scatter_ = 0.0;
  int spare_ = 0;
};

}  // namespace muckpile
