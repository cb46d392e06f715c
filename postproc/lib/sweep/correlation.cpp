// SPDX-License-Identifier: GPL-2.0-or-later
// How closely two quantities go together, and how one follows from several.
// Scope: see the header.
#include "sweep/correlation.h"

#include <Eigen/LU>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <numeric>

namespace muckpile {
namespace {

using Column = Eigen::VectorXd;

Column about_mean(const std::vector<double>& values) {
  const Column column = Column::Map(values.data(), static_cast<Eigen::Index>(values.size()));
  return column.array() - column.mean();
}

}  // namespace

std::optional<double> correlation(const std::vector<double>& a, const std::vector<double>& b) {
  if (a.empty()) return std::nullopt;
  const Column x = about_mean(a), y = about_mean(b);
  const double scale = x.norm() * y.norm();
  if (!(scale > 0.0)) return std::nullopt;
  return std::clamp(x.dot(y) / scale, -1.0, 1.0);
}

std::vector<double> ranks_of(const std::vector<double>& values) {
  std::vector<size_t> order(values.size());
  std::iota(order.begin(), order.end(), size_t{0});
  std::ranges::sort(order, {}, [&](size_t k) { return values[k]; });
  std::vector<double> ranks(values.size());
  for (size_t first = 0; first < order.size();) {
    size_t end = first;
    while (end < order.size() && values[order[end]] == values[order[first]]) ++end;
    const double mean = 0.5 * static_cast<double>(first + 1 + end);
    for (; first < end; ++first) ranks[order[first]] = mean;
  }
  return ranks;
}

std::optional<double> rank_correlation(const std::vector<double>& a, const std::vector<double>& b) {
  return correlation(ranks_of(a), ranks_of(b));
}

std::optional<LinearLaw> fit_linear(const std::vector<std::vector<double>>& x,
                                    const std::vector<double>& y) {
  const auto runs = static_cast<Eigen::Index>(y.size());
  const auto quantities = static_cast<Eigen::Index>(x.size());
  const Eigen::Index spare = runs - quantities - 1;
  if (spare < 1 || quantities == 0) return std::nullopt;
  Eigen::MatrixXd design(runs, quantities);
  for (Eigen::Index k = 0; k < quantities; ++k)
    design.col(k) = about_mean(x[static_cast<size_t>(k)]);
  const Column sizes = design.colwise().norm();
  if (!(sizes.minCoeff() > 0.0)) return std::nullopt;
  design.array().rowwise() /= sizes.transpose().array();
  const Column target = about_mean(y);
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> solver(design);
  if (solver.rank() < quantities || !(target.norm() > 0.0)) return std::nullopt;
  const Column slopes = solver.solve(target);
  const double left = (target - design * slopes).squaredNorm();
  const Eigen::MatrixXd inverse = (design.transpose() * design).inverse();
  LinearLaw law;
  law.explained = 1.0 - left / target.squaredNorm();
  for (Eigen::Index k = 0; k < quantities; ++k) {
    law.slopes.push_back(slopes(k) / sizes(k));
    law.errors.push_back(std::sqrt(left / static_cast<double>(spare) * inverse(k, k)) / sizes(k));
  }
  return law;
}

}  // namespace muckpile
