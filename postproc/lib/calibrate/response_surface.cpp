// SPDX-License-Identifier: GPL-2.0-or-later
// A figure of a run as a polynomial of the uncertain constants.
// Scope: see the header.
#include "calibrate/response_surface.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "args/input_error.h"

namespace muckpile {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

// 1, each place, then each product of two.
VectorXd terms_at(SurfaceOrder order, const VectorXd& place) {
  const Index n = place.size();
  VectorXd terms(static_cast<Index>(terms_of(order, static_cast<size_t>(n))));
  terms[0] = 1.0;
  terms.segment(1, n) = place;
  if (order == SurfaceOrder::kLinear) return terms;
  Index term = n + 1;
  for (Index i = 0; i < n; ++i)
    for (Index j = i; j < n; ++j) terms[term++] = place[i] * place[j];
  return terms;
}

}  // namespace

double LogScale::place_of(double value) const { return (std::log(value) - middle) / half; }
double LogScale::value_at(double place) const { return std::exp(middle + half * place); }

LogScale log_scale(const std::vector<double>& values) {
  const auto [least, largest] = std::ranges::minmax(values);
  return {0.5 * std::log(least * largest), 0.5 * std::log(largest / least)};
}

size_t terms_of(SurfaceOrder order, size_t constants) {
  const size_t linear = 1 + constants;
  return order == SurfaceOrder::kLinear ? linear : linear + constants * (constants + 1) / 2;
}

ResponseSurface::ResponseSurface(SurfaceOrder order, const Eigen::MatrixXd& places,
                                 const VectorXd& values, const std::string& name)
    : order_(order) {
  const auto terms = static_cast<Index>(terms_of(order, static_cast<size_t>(places.cols())));
  spare_ = static_cast<int>(places.rows() - terms);
  if (spare_ < 1)
    refuse(name, "has a value in " + std::to_string(places.rows()) + " runs; a surface of " +
                     std::to_string(terms) + " terms needs " + std::to_string(terms + 1) +
                     " at least");
  Eigen::MatrixXd all(places.rows(), terms);
  for (Index run = 0; run < places.rows(); ++run)
    all.row(run) = terms_at(order, places.row(run).transpose()).transpose();
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> solver(all);
  if (solver.rank() < terms)
    refuse(name,
           "has a value in runs that do not tell the terms of its surface apart; sweep each "
           "constant over three values, in all combinations, or fit with --order linear");
  factors_ = solver.solve(values);
  scatter_ = (all * factors_ - values).norm() / std::sqrt(static_cast<double>(spare_));
}

double ResponseSurface::at(const VectorXd& place) const {
  return factors_.dot(terms_at(order_, place));
}

VectorXd ResponseSurface::slope(const VectorXd& place) const {
  const Index n = place.size();
  VectorXd slope = factors_.segment(1, n);
  if (order_ == SurfaceOrder::kLinear) return slope;
  Index term = n + 1;
  for (Index i = 0; i < n; ++i) {
    for (Index j = i; j < n; ++j, ++term) {
      slope[i] += factors_[term] * place[j];
      slope[j] += factors_[term] * place[i];
    }
  }
  return slope;
}

}  // namespace muckpile
