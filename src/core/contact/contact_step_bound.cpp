// SPDX-License-Identifier: GPL-2.0-or-later
// How long a time step the contacts of rigid bodies bear.
// Scope: see the header.
#include "contact/contact_step_bound.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <utility>

namespace muckpile {
namespace {

/// No limit shorter than `step`, as no eigenvalue is above these.
bool bears(double step, double stiffness, double damping) {
  return std::isinf(step) ? stiffness == 0.0 && damping == 0.0
                          : step * (step * stiffness + 2.0 * damping) <= 4.0;
}

/// r x of a vector.
Mat3 cross_with(const Vec3& r) {
  Mat3 matrix;
  matrix << 0.0, -r.z(), r.y(), r.z(), 0.0, -r.x(), -r.y(), r.x(), 0.0;
  return matrix;
}

}  // namespace

ContactStepBound::ContactStepBound(std::vector<Body> bodies)
    : bodies_(std::move(bodies)), sums_(bodies_.size()) {}

/// The point is displaced by s + t x arm; tangential (|s + t x arm|^2) + the rest of the normal.
void ContactStepBound::Form::add(double normal, double tangential, const Vec3& direction,
                                 const Vec3& arm) {
  const double rest = normal - tangential;
  const Vec3 lever = arm.cross(direction);
  ss.diagonal().array() += tangential;
  ss.noalias() += rest * direction * direction.transpose();
  st -= tangential * cross_with(arm);
  st.noalias() += rest * direction * lever.transpose();
  tt.diagonal().array() += tangential * arm.squaredNorm();
  tt.noalias() -= tangential * arm * arm.transpose();
  tt.noalias() += rest * lever * lever.transpose();
}

/// Most bodies are no limit by their traces alone; the forms of the others are worked out later.
void ContactStepBound::add(std::size_t b, const ContactResistance& contact, const Vec3& normal,
                           const Vec3& arm, double other_mass) {
  const Body& body = bodies_[b];
  const double weight = 1.0 + std::sqrt(body.mass / other_mass);
  const ContactResistance weighted = {
      weight * contact.normal_stiffness,   weight * contact.tangential_stiffness,
      weight * contact.rolling_stiffness,  weight * contact.normal_damping,
      weight * contact.tangential_damping, weight * contact.torsional_stiffness};
  const Vec3 lever = body.axes.transpose() * arm.cross(normal);
  const Vec3 across = body.axes.transpose() * arm, spin = body.axes.transpose() * normal;
  // Of turns about each axis, over the moment: tangential, what the normal has more, spin.
  double turning = 0.0, tilting = 0.0, rolling = 0.0, twisting = 0.0;
  for (int k = 0; k < 3; ++k) {
    const double slim = 1.0 / body.inertia[k];
    turning += slim * (arm.squaredNorm() - across[k] * across[k]);
    tilting += slim * lever[k] * lever[k];
    rolling += slim * (1.0 - spin[k] * spin[k]);
    twisting += slim * spin[k] * spin[k];
  }
  const auto trace = [&](double along, double tangential) {
    return (along + 2.0 * tangential) / body.mass + tangential * turning +
           (along - tangential) * tilting;
  };
  Sum& sum = sums_[b];
  sum.stiffness += trace(weighted.normal_stiffness, weighted.tangential_stiffness) +
                   weighted.rolling_stiffness * rolling + weighted.torsional_stiffness * twisting;
  sum.damping += trace(weighted.normal_damping, weighted.tangential_damping);
  contacts_.push_back({weighted, normal, arm, sum.contact});
  sum.contact = static_cast<int>(contacts_.size()) - 1;
}

/// Along the body's axes.
ContactStepBound::Mat6 ContactStepBound::over_mass(const Form& form, const Body& body) {
  const double slim = 1.0 / std::sqrt(body.mass);
  const Mat3 turn = body.axes * body.inertia.cwiseSqrt().cwiseInverse().asDiagonal();
  Mat6 matrix;
  matrix.topLeftCorner<3, 3>() = slim * slim * form.ss;
  matrix.topRightCorner<3, 3>() = slim * form.st * turn;
  matrix.bottomLeftCorner<3, 3>() = matrix.topRightCorner<3, 3>().transpose();
  matrix.bottomRightCorner<3, 3>() = turn.transpose() * form.tt * turn;
  return matrix;
}

/// The sum of the eigenvalues shows most bodies to be no limit, once one that is among the
/// stiffest is known.
ContactStepBound::Steps ContactStepBound::steps(bool joined) const {
  std::vector<std::size_t> candidates;
  std::size_t stiffest = 0;
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    if (sums_[b].contact < 0 || bodies_[b].joined != joined) continue;
    candidates.push_back(b);
    if (sums_[b].stiffness > sums_[candidates[stiffest]].stiffness)
      stiffest = candidates.size() - 1;
  }
  Steps steps;
  if (candidates.empty()) return steps;
  std::swap(candidates.front(), candidates[stiffest]);
  for (const std::size_t body : candidates) {
    const Sum& sum = sums_[body];
    if (sum.stiffness == 0.0 && sum.damping == 0.0) continue;
    if (!bears(steps.springs, sum.stiffness, 0.0) ||
        !bears(steps.with_dashpots, sum.stiffness, sum.damping))
      steps = shorten(steps, body);
  }
  return steps;
}

ContactStepBound::Steps ContactStepBound::shorten(Steps steps, std::size_t body) const {
  Form springs, dashpots;
  for (int k = sums_[body].contact; k >= 0; k = contacts_[static_cast<std::size_t>(k)].next) {
    const Contact& contact = contacts_[static_cast<std::size_t>(k)];
    const ContactResistance& r = contact.resistance;
    springs.add(r.normal_stiffness, r.tangential_stiffness, contact.normal, contact.arm);
    dashpots.add(r.normal_damping, r.tangential_damping, contact.normal, contact.arm);
    springs.tt.diagonal().array() += r.rolling_stiffness;
    springs.tt.noalias() -=
        (r.rolling_stiffness - r.torsional_stiffness) * contact.normal * contact.normal.transpose();
  }
  const Mat6 stiffness = over_mass(springs, bodies_[body]);
  return {limit(stiffness, Mat6::Zero(), steps.springs),
          limit(stiffness, over_mass(dashpots, bodies_[body]), steps.with_dashpots)};
}

/// A body's limit if that is shorter, else `shorter_than`; stiffness and damping are scaled by its
/// mass. The largest eigenvalue of s^2 K + 2 s C is a convex function of the step s, so Newton's
/// method finds where it is 4 from above.
double ContactStepBound::limit(const Mat6& stiffness, const Mat6& damping, double shorter_than) {
  // The root of the sum of squares is an upper bound of the eigenvalues, too.
  if (bears(shorter_than, stiffness.norm(), damping.norm())) return shorter_than;
  constexpr int kMostRounds = 50;
  constexpr double kSettled = 1e-12;
  // The largest of six eigenvalues is a sixth of their sum at least.
  const double springs = stiffness.trace() / 6.0, dashpots = damping.trace() / 6.0;
  double step = std::min({shorter_than, springs > 0.0 ? 2.0 / std::sqrt(springs) : shorter_than,
                          dashpots > 0.0 ? 2.0 / dashpots : shorter_than});
  for (int round = 0; round < kMostRounds; ++round) {
    const Eigen::SelfAdjointEigenSolver<Mat6> solver(step * (step * stiffness + 2.0 * damping));
    const Eigen::Matrix<double, 6, 1> fastest = solver.eigenvectors().col(5);
    const double excess = solver.eigenvalues()[5] - 4.0;
    const double slope = 2.0 * fastest.dot((step * stiffness + damping) * fastest);
    if (!(excess > 0.0 && slope > 0.0)) break;
    step -= excess / slope;
    if (excess < kSettled * step * slope) break;
  }
  return step;
}

}  // namespace muckpile
