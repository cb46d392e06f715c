// SPDX-License-Identifier: GPL-2.0-or-later
// Uncertain constants from measured figures.
// Scope: see the header.
#include "calibrate/calibration.h"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

namespace muckpile {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kEvenVariance = 1.0 / 3.0;  // of a place evenly likely from -1 to 1

VectorXd differences(const std::vector<Target>& targets, const VectorXd& place) {
  VectorXd over(static_cast<Index>(targets.size()));
  for (size_t k = 0; k < targets.size(); ++k)
    over[static_cast<Index>(k)] =
        (targets[k].value - targets[k].surface.at(place)) / targets[k].deviation;
  return over;
}

MatrixXd slopes(const std::vector<Target>& targets, const VectorXd& place) {
  MatrixXd all(static_cast<Index>(targets.size()), place.size());
  for (size_t k = 0; k < targets.size(); ++k)
    all.row(static_cast<Index>(k)) =
        targets[k].surface.slope(place).transpose() / targets[k].deviation;
  return all;
}

std::vector<Direction> directions_of(const MatrixXd& slopes) {
  const Eigen::JacobiSVD<MatrixXd> parts(slopes, Eigen::ComputeFullV);
  std::vector<Direction> all;
  for (Index k = 0; k < slopes.cols(); ++k) {
    const bool is_there = k < parts.singularValues().size();
    all.push_back({is_there ? parts.singularValues()[k] : 0.0, parts.matrixV().col(k)});
  }
  return all;
}

// The damped step in the resolved directions; constants at an edge that it would push out stay.
VectorXd step_at(const std::vector<Target>& targets, const VectorXd& place, double damping) {
  const VectorXd over = differences(targets, place);
  MatrixXd all = slopes(targets, place);
  const VectorXd pull = all.transpose() * over;
  for (Index i = 0; i < place.size(); ++i) {
    if (std::abs(place[i]) >= 1.0 && pull[i] * place[i] > 0.0) all.col(i).setZero();
  }
  VectorXd step = VectorXd::Zero(place.size());
  for (const Direction& each : directions_of(all)) {
    if (!each.is_resolved()) continue;
    const double square = each.sharpness * each.sharpness;
    step += each.way.dot(all.transpose() * over) / (square * (1.0 + damping)) * each.way;
  }
  return step;
}

VectorXd fitted_from(const std::vector<Target>& targets, VectorXd place) {
  constexpr int kSteps = 200;
  constexpr double kNear = 1e-12, kMostDamping = 1e12;
  double damping = 1e-3, misfit = differences(targets, place).squaredNorm();
  for (int k = 0; k < kSteps && damping < kMostDamping; ++k) {
    const VectorXd step = step_at(targets, place, damping);
    if (step.norm() < kNear) break;
    const VectorXd next = (place + step).cwiseMax(-1.0).cwiseMin(1.0);
    const double there = differences(targets, next).squaredNorm();
    if (there < misfit) {
      place = next;
      misfit = there;
      damping *= 0.2;
    } else {
      damping = std::max(4.0 * damping, 1e-3);
    }
  }
  return place;
}

// The middle, then half-way to each corner.
std::vector<VectorXd> starts(size_t constants) {
  std::vector<VectorXd> all{VectorXd::Zero(static_cast<Index>(constants))};
  for (size_t corner = 0; corner < (size_t{1} << constants); ++corner) {
    VectorXd start(static_cast<Index>(constants));
    for (size_t i = 0; i < constants; ++i)
      start[static_cast<Index>(i)] = ((corner >> i) & 1U) != 0 ? 0.5 : -0.5;
    all.push_back(start);
  }
  return all;
}

}  // namespace

size_t Calibration::resolved() const {
  return static_cast<size_t>(std::ranges::count_if(directions, &Direction::is_resolved));
}

bool Calibration::at_edge(size_t constant) const {
  constexpr double kNear = 1e-6;
  return std::abs(place[static_cast<Index>(constant)]) > 1.0 - kNear;
}

Calibration calibrate(const std::vector<Target>& targets, size_t constants) {
  constexpr double kBetter = 1.0;  // of the misfit, by which one standard deviation is off
  Calibration best;
  for (const VectorXd& start : starts(constants)) {
    const VectorXd place = fitted_from(targets, start);
    const double misfit = differences(targets, place).squaredNorm();
    if (best.place.size() != 0 && !(misfit < best.misfit - kBetter)) continue;
    best.place = place;
    best.misfit = misfit;
  }
  best.directions = directions_of(slopes(targets, best.place));
  const auto n = static_cast<Index>(constants);
  best.covariance = MatrixXd::Zero(n, n);
  for (const Direction& each : best.directions) {
    const double variance =
        each.is_resolved() ? 1.0 / (each.sharpness * each.sharpness) : kEvenVariance;
    best.covariance += variance * each.way * each.way.transpose();
  }
  return best;
}

}  // namespace muckpile
