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

void ContactStepBound::add(std::size_t body, const ContactResistance& contact, const Vec3& normal,
                           const Vec3& arm, double other_mass) {
  Sum& sum = sums_[body];
  const double weight = 1.0 + std::sqrt(bodies_[body].mass / other_mass);
  sum.stiffness.add(weight * contact.normal_stiffness, weight * contact.tangential_stiffness,
                    normal, arm);
  sum.damping.add(weight * contact.normal_damping, weight * contact.tangential_damping, normal,
                  arm);
  const double rolling = weight * contact.rolling_stiffness;
  sum.stiffness.tt.diagonal().array() += rolling;
  sum.stiffness.tt.noalias() -=
      (rolling - weight * contact.torsional_stiffness) * normal * normal.transpose();
}

double ContactStepBound::trace_over_mass(const Form& form, const Body& body) {
  const Mat3 turned = form.tt * body.axes;
  double trace = form.ss.trace() / body.mass;
  for (int k = 0; k < 3; ++k) trace += body.axes.col(k).dot(turned.col(k)) / body.inertia[k];
  return trace;
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
  std::vector<std::pair<std::size_t, Traces>> candidates;
  std::size_t stiffest = 0;
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    if (bodies_[b].joined != joined) continue;
    const Traces traces{trace_over_mass(sums_[b].stiffness, bodies_[b]),
                        trace_over_mass(sums_[b].damping, bodies_[b])};
    if (traces.stiffness == 0.0 && traces.damping == 0.0) continue;
    candidates.emplace_back(b, traces);
    if (traces.stiffness > candidates[stiffest].second.stiffness) stiffest = candidates.size() - 1;
  }
  Steps steps;
  if (candidates.empty()) return steps;
  std::swap(candidates.front(), candidates[stiffest]);
  for (const auto& [body, traces] : candidates) {
    if (!bears(steps.springs, traces.stiffness, 0.0) ||
        !bears(steps.with_dashpots, traces.stiffness, traces.damping))
      steps = shorten(steps, body);
  }
  return steps;
}

ContactStepBound::Steps ContactStepBound::shorten(Steps steps, std::size_t body) const {
  const Mat6 stiffness = over_mass(sums_[body].stiffness, bodies_[body]);
  return {limit(stiffness, Mat6::Zero(), steps.springs),
          limit(stiffness, over_mass(sums_[body].damping, bodies_[body]), steps.with_dashpots)};
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
