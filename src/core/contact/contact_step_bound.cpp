// SPDX-License-Identifier: GPL-2.0-or-later
// How long a time step the contacts of rigid bodies bear.
// Scope: see the header.
#include "contact/contact_step_bound.h"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <limits>

namespace muckpile {

void ContactStepBound::add(std::size_t number, const Body& body, const ContactResistance& contact,
                           const Vec3& normal, const Vec3& arm, double other_mass) {
  Sum& sum = sums_[number];
  if (sum.slim.isZero()) {
    sum.slim.topLeftCorner<3, 3>() = Mat3::Identity() / std::sqrt(body.mass);
    sum.slim.bottomRightCorner<3, 3>() =
        Eigen::SelfAdjointEigenSolver<Mat3>(body.inertia).operatorInverseSqrt();
  }
  // Displacement of the point: shift + turn x arm.
  Eigen::Matrix<double, 3, 6> moved;
  moved << Mat3::Identity(), Mat3::Zero();
  for (int k = 0; k < 3; ++k) moved.col(3 + k) = Vec3::Unit(k).cross(arm);
  const Mat3 across = normal * normal.transpose(), along = Mat3::Identity() - across;
  const double weight = 1.0 + std::sqrt(body.mass / other_mass);
  const Mat3 spring = contact.normal_stiffness * across + contact.tangential_stiffness * along;
  const Mat3 dashpot = contact.normal_damping * across + contact.tangential_damping * along;
  sum.stiffness += weight * (moved.transpose() * spring * moved);
  sum.stiffness.bottomRightCorner<3, 3>() += weight * contact.rolling_stiffness * along;
  sum.damping += weight * (moved.transpose() * dashpot * moved);
}

double ContactStepBound::shortest(bool damped) const {
  double step = std::numeric_limits<double>::infinity();
  for (const auto& [number, sum] : sums_) {
    const Mat6 stiffness = sum.slim * sum.stiffness * sum.slim;
    const Mat6 damping = damped ? Mat6(sum.slim * sum.damping * sum.slim) : Mat6(Mat6::Zero());
    step = limit(stiffness, damping, step);
  }
  return step;
}

/// A body's limit if that is shorter, else `shorter_than`; stiffness and damping are scaled by its
/// mass. The step s that solves s = 2/sqrt(largest eigenvalue of K + (2/s) C) is approached from
/// above.
double ContactStepBound::limit(const Mat6& stiffness, const Mat6& damping, double shorter_than) {
  // The root of the sum of squares is an upper bound of the eigenvalues, and shows most bodies to
  // be no limit.
  const double s = shorter_than;
  if (s * (s * stiffness.norm() + 2.0 * damping.norm()) <= 4.0) return shorter_than;
  constexpr int kMostRounds = 200;
  constexpr double kSettled = 1e-4;
  double step = shorter_than;
  for (int round = 0; round < kMostRounds; ++round) {
    const double rate = std::isinf(step) ? 0.0 : 2.0 / step;
    const double eigenvalue =
        Eigen::SelfAdjointEigenSolver<Mat6>(stiffness + rate * damping, Eigen::EigenvaluesOnly)
            .eigenvalues()[5];
    if (!(eigenvalue > 0.0)) break;
    const double next = 2.0 / std::sqrt(eigenvalue);
    if (next >= step) break;
    const bool settled = step - next < kSettled * next;
    step = next;
    if (settled) break;
  }
  return step;
}

}  // namespace muckpile
