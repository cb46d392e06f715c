// SPDX-License-Identifier: GPL-2.0-or-later
// How a free body turns: a symmetric top against its closed form, energy of any top, order, and
// Richardson's rotation of LIGGGHTS beside it.
// Scope: motion/turn.h.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "math/types.h"
#include "motion/rows.h"
#include "motion/turn.h"

namespace muckpile {
namespace {

/// A body that turns freely.
struct Top {
  Vec3 inertia, momentum;  // principal moments [kg m2]; in space [kg m2/s]
  Quat pose;

  [[nodiscard]] Vec3 spin(const Quat& at) const {
    const Mat3 axes = at.toRotationMatrix();
    return axes * (axes.transpose() * momentum).cwiseQuotient(inertia);
  }
  [[nodiscard]] double energy(const Quat& at) const { return 0.5 * momentum.dot(spin(at)); }
};

constexpr int kLane = kBodyLanes - 1;  // all carry the same

using Step = std::function<Quat(const Top&, const Quat&, double)>;

Quat ours(const Top& top, const Quat& q, double step) {
  const auto turning =
      turned<BodyLanes>({q.w(), BodyVectors(Vec3(q.vec()))}, BodyVectors(top.momentum),
                        BodyVectors(Vec3(top.inertia.cwiseInverse())), step);
  const VectorOf<BodyLanes>& v = turning.pose.v;
  return {turning.pose.w[kLane], v.x[kLane], v.y[kLane], v.z[kLane]};
}

/// LIGGGHTS' MathExtra::richardson: a whole step of Euler's and two halves, extrapolated.
Quat richardson(const Top& top, const Quat& q, double step) {
  const auto euler = [](const Quat& at, const Vec3& spin, double time) {
    Quat next = at;
    next.coeffs() += 0.5 * time * (Quat(0.0, spin.x(), spin.y(), spin.z()) * at).coeffs();
    return next.normalized();
  };
  const Quat whole = euler(q, top.spin(q), step), middle = euler(q, top.spin(q), 0.5 * step);
  Quat halves = euler(middle, top.spin(middle), 0.5 * step);
  halves.coeffs() = 2.0 * halves.coeffs() - whole.coeffs();
  return halves.normalized();
}

Quat after(const Step& law, const Top& top, int steps, double time) {
  Quat q = top.pose;
  for (int k = 0; k < steps; ++k) q = law(top, q, time / steps);
  return q;
}

/// A symmetric top: about its momentum by |L| / I_1, about its own axis by L_3 (1 / I_3 - 1 / I_1).
Quat precession(const Top& top, double time) {
  const double across = top.inertia.x(), along = top.inertia.z();
  const double own =
      (top.pose.toRotationMatrix().transpose() * top.momentum).z() * (1.0 / along - 1.0 / across);
  return Quat(Eigen::AngleAxisd(top.momentum.norm() / across * time,
                                Vec3(top.momentum.normalized()))) *
         top.pose * Quat(Eigen::AngleAxisd(own * time, Vec3::UnitZ()));
}

const Quat kPose = Quat(0.3, -0.5, 0.7, 0.2).normalized();
const Top kSymmetric{{1.0, 1.0, 1.6}, {0.4, -0.9, 0.7}, kPose};
constexpr double kTime = 10.0;  // some two turns [s]

TEST(Turn, FollowsThePrecessionOfASymmetricTopInSecondOrder) {
  const Quat exact = precession(kSymmetric, kTime);
  const auto error = [&](int steps) {
    return after(ours, kSymmetric, steps, kTime).angularDistance(exact);
  };
  const double coarse = error(200), fine = error(400), finest = error(800);
  EXPECT_LT(coarse, 2e-3);
  EXPECT_NEAR(std::log2(coarse / fine), 2.0, 0.1);
  EXPECT_NEAR(std::log2(fine / finest), 2.0, 0.05);
}

TEST(Turn, IsCloserToTheClosedFormThanRichardsonsRotation) {
  const Quat exact = precession(kSymmetric, kTime);
  for (const int steps : {200, 2000, 20000}) {
    const double here = after(ours, kSymmetric, steps, kTime).angularDistance(exact);
    const double there = after(richardson, kSymmetric, steps, kTime).angularDistance(exact);
    EXPECT_LT(here, 0.5 * there) << steps;
    EXPECT_GT(here, 0.0) << steps;
  }
}

TEST(Turn, KeepsTheEnergyOfATumblingBodyBetterThanRichardsonsRotation) {
  for (const Vec3& inertia : {Vec3(1.0, 2.0, 2.5), Vec3(0.3, 1.0, 1.1), Vec3(1.0, 1.5, 2.4)}) {
    const Top top{inertia, {0.4, -0.9, 0.7}, kPose};
    const auto change = [&](const Step& law, int steps) {
      return std::abs(top.energy(after(law, top, steps, 20.0)) / top.energy(kPose) - 1.0);
    };
    EXPECT_LT(change(ours, 400), 0.5 * change(richardson, 400)) << inertia.transpose();
    // Third order, where that of the pose is the second.
    EXPECT_LT(change(ours, 800), change(ours, 400) / 6.0) << inertia.transpose();
  }
}

TEST(Turn, LeavesQuaternionsUnitAndAxesAtRightAngles) {
  Quat q = kPose;
  for (int k = 0; k < 10000; ++k) q = ours(kSymmetric, q, 0.01);
  EXPECT_NEAR(q.norm(), 1.0, 1e-15);
  const QuaternionOf<BodyLanes> lanes{q.w(), BodyVectors(Vec3(q.vec()))};
  const MatrixOf<BodyLanes> axes = axes_of(lanes);
  Mat3 columns;
  columns << axes.x.at(kLane), axes.y.at(kLane), axes.z.at(kLane);
  EXPECT_LT((columns.transpose() * columns - Mat3::Identity()).norm(), 1e-14);
  EXPECT_LT((columns - q.toRotationMatrix()).norm(), 1e-14);
}

TEST(Turn, GivesTheSpinOfMidStep) {
  constexpr double kStep = 1e-3;
  const auto turning = turned<BodyLanes>(
      {kPose.w(), BodyVectors(Vec3(kPose.vec()))}, BodyVectors(kSymmetric.momentum),
      BodyVectors(Vec3(kSymmetric.inertia.cwiseInverse())), kStep);
  const Vec3 expected = kSymmetric.spin(precession(kSymmetric, 0.5 * kStep));
  EXPECT_LT((turning.spin.at(kLane) - expected).norm(), kStep * kStep);
}

TEST(Turn, DoesNotTurnABodyAboutAnAxisWithoutInertia) {
  const auto turning = turned<BodyLanes>({1.0, {}}, BodyVectors(Vec3(1.0, 2.0, 3.0)),
                                         BodyVectors(Vec3(0.0, 0.0, 0.5)), 1e-3);
  EXPECT_LT((turning.spin.at(0) - Vec3(0.0, 0.0, 1.5)).norm(), 1e-15);
}

}  // namespace
}  // namespace muckpile
