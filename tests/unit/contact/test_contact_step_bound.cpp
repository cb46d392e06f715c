// SPDX-License-Identifier: GPL-2.0-or-later
// The bound on the time step is exact where it can be, and an upper bound on stiffness elsewhere.
// Scope: masses on springs with dashpots, integrated with the engine's leapfrog.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "contact/contact_step_bound.h"

namespace muckpile {
namespace {

constexpr double kMass = 3.0, kStiffness = 2e5;  // [kg], [N/m]

/// Largest elongation after many steps of two masses on one spring, the dashpot at mid-step speed.
double swing(double damping, double dt) {
  double gap = 1e-3, rate = 0.0;
  for (int step = 0; step < 4000 && std::abs(gap) < 1.0; ++step) {
    rate += dt * (-kStiffness * gap - damping * rate) * 2.0 / kMass;
    gap += dt * rate;
  }
  return std::abs(gap);
}

/// A body that cannot turn.
const ContactStepBound::Body kMassPoint{kMass, Vec3::Constant(1e12), Mat3::Identity()};

using Mat6 = Eigen::Matrix<double, 6, 6>;

struct RandomContact {
  std::size_t body;
  ContactResistance resistance;
  Vec3 normal, arm;
  double other_mass;
};

ContactResistance spring(double damping) { return {kStiffness, 0.0, 0.0, damping, 0.0}; }

TEST(ContactStepBound, IsTheLimitOfTwoMassesOnOneSpringWithDashpot) {
  for (const double damping : {0.0, 300.0, 2000.0}) {
    ContactStepBound bound({kMassPoint, kMassPoint});
    for (const std::size_t body : {0u, 1u})
      bound.add(body, spring(damping), Vec3::UnitX(), Vec3::Zero(), kMass);
    EXPECT_LE(swing(damping, 0.995 * bound.steps(false).with_dashpots), 1.1e-2) << damping;
    EXPECT_GT(swing(damping, 1.01 * bound.steps(false).with_dashpots), 1.0) << damping;
  }
}

TEST(ContactStepBound, UndampedPairByHand) {
  ContactStepBound bound({kMassPoint});
  bound.add(0, spring(0.0), Vec3::UnitX(), Vec3::Zero(), kMass);
  EXPECT_NEAR(bound.steps(false).springs / (2.0 / std::sqrt(2.0 * kStiffness / kMass)), 1.0, 1e-12);
}

TEST(ContactStepBound, UnequalPairIsWithinATenth) {
  // omega^2 = k (1/m + 1/M); the light body's part of the bound is k (1/m + 1/sqrt(m M)).
  for (const double ratio : {1.0, 4.0, 100.0, 1e4}) {
    ContactStepBound::Body heavy = kMassPoint;
    heavy.mass = ratio * kMass;
    ContactStepBound bound({kMassPoint, heavy});
    bound.add(0, spring(0.0), Vec3::UnitX(), Vec3::Zero(), heavy.mass);
    bound.add(1, spring(0.0), Vec3::UnitX(), Vec3::Zero(), kMass);
    const double exact = 2.0 / std::sqrt(kStiffness / kMass * (1.0 + 1.0 / ratio));
    EXPECT_LE(bound.steps(false).springs, exact * (1.0 + 1e-12)) << ratio;
    EXPECT_GE(bound.steps(false).springs, 0.9 * exact) << ratio;
  }
}

TEST(ContactStepBound, ContactsAcrossEachOtherDoNotAddUp) {
  // Two contacts along each axis: omega^2 = 2 x 2 k / m, as for those of one axis alone. With both
  // of them in a chain that is also the exact value.
  ContactStepBound bound({kMassPoint});
  for (int axis = 0; axis < 3; ++axis)
    for (int side = 0; side < 2; ++side)
      bound.add(0, spring(0.0), Vec3::Unit(axis), Vec3::Zero(), kMass);
  EXPECT_NEAR(bound.steps(false).springs / (2.0 / std::sqrt(4.0 * kStiffness / kMass)), 1.0, 1e-12);
}

TEST(ContactStepBound, TurningCounts) {
  // Tangential spring k_t at arm r: omega^2 = 2 k_t (1/m + r^2/I), here 2 k_t (1/m + 2/m); the
  // rolling spring acts beside it, about the other axis 2 k_r/I.
  const double inertia = 0.5 * kMass;
  const ContactStepBound::Body body{kMass, Vec3::Constant(inertia), Mat3::Identity()};
  ContactStepBound sliding({body});
  sliding.add(0, {0.0, kStiffness, 0.0, 0.0, 0.0}, Vec3::UnitX(), Vec3::UnitX(), kMass);
  EXPECT_NEAR(sliding.steps(false).springs / (2.0 / std::sqrt(6.0 * kStiffness / kMass)), 1.0,
              1e-12);
  ContactStepBound rolling({body});
  rolling.add(0, {0.0, 0.0, kStiffness, 0.0, 0.0}, Vec3::UnitX(), Vec3::UnitX(), kMass);
  EXPECT_NEAR(rolling.steps(false).springs / (2.0 / std::sqrt(2.0 * kStiffness / inertia)), 1.0,
              1e-12);
}

TEST(ContactStepBound, TheWorstBodyCounts) {
  for (const bool light_first : {false, true}) {
    ContactStepBound::Body light = kMassPoint;
    light.mass = 0.01 * kMass;
    ContactStepBound bound(light_first ? std::vector{light, kMassPoint}
                                       : std::vector{kMassPoint, light});
    bound.add(light_first ? 0 : 1, spring(50.0), Vec3::UnitZ(), Vec3::Zero(), light.mass);
    bound.add(light_first ? 1 : 0, spring(50.0), Vec3::UnitZ(), Vec3::Zero(), kMass);
    const double omega = std::sqrt(2.0 * kStiffness / light.mass),
                 zeta = 50.0 / (light.mass * omega);
    EXPECT_NEAR(
        bound.steps(false).with_dashpots / (2.0 / omega * (std::sqrt(1.0 + zeta * zeta) - zeta)),
        1.0, 1e-3);
  }
}

/// As the header says it, body by body: no packing, no body left out.
double by_displacements(const std::vector<ContactStepBound::Body>& bodies,
                        const std::vector<RandomContact>& contacts, bool damped) {
  double step = std::numeric_limits<double>::infinity();
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    Mat6 stiffness = Mat6::Zero(), damping = Mat6::Zero(), slim = Mat6::Zero();
    slim.topLeftCorner<3, 3>() = Mat3::Identity() / std::sqrt(bodies[b].mass);
    slim.bottomRightCorner<3, 3>() =
        bodies[b].axes * bodies[b].inertia.cwiseSqrt().cwiseInverse().asDiagonal();
    for (const RandomContact& c : contacts) {
      if (c.body != b) continue;
      const double weight = 1.0 + std::sqrt(bodies[b].mass / c.other_mass);
      Eigen::Matrix<double, 3, 6> moved, turned;
      moved << Mat3::Identity(), Mat3::Zero();
      turned << Mat3::Zero(), Mat3::Identity();
      for (int k = 0; k < 3; ++k) moved.col(3 + k) = Vec3::Unit(k).cross(c.arm);
      const Mat3 across = c.normal * c.normal.transpose(), along = Mat3::Identity() - across;
      const auto form = [&](const auto& map, double normal, double tangential) -> Mat6 {
        return weight * map.transpose() * (normal * across + tangential * along) * map;
      };
      const ContactResistance& r = c.resistance;
      stiffness += form(moved, r.normal_stiffness, r.tangential_stiffness) +
                   form(turned, r.torsional_stiffness, r.rolling_stiffness);
      damping += form(moved, r.normal_damping, r.tangential_damping);
    }
    const Mat6 k = slim.transpose() * stiffness * slim, c = slim.transpose() * damping * slim;
    const auto too_long = [&](double s) {
      return Eigen::SelfAdjointEigenSolver<Mat6>(s * s * k + (damped ? 2.0 * s : 0.0) * c)
                 .eigenvalues()[5] > 4.0;
    };
    double low = 0.0, high = 1.0;
    for (int halving = 0; halving < 60; ++halving)
      (too_long(0.5 * (low + high)) ? high : low) = 0.5 * (low + high);
    step = std::min(step, low);
  }
  return step;
}

TEST(ContactStepBound, IsThatOfAllBodiesWorkedOutOneByOne) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  const auto vector = [&] {
    return Vec3(Vec3(share(random), share(random), share(random)) * 2.0 - Vec3::Ones());
  };
  for (int round = 0; round < 20; ++round) {
    std::vector<ContactStepBound::Body> bodies;
    for (int b = 0; b < 30; ++b)
      bodies.push_back(
          {std::pow(10.0, 2.0 * share(random)),
           Vec3::Constant(0.1) + Vec3(share(random), share(random), share(random)),
           Quat(Eigen::AngleAxisd(3.0 * share(random), vector().normalized())).toRotationMatrix()});
    std::vector<RandomContact> contacts;
    for (std::size_t c = 0; c < 100; ++c)
      contacts.push_back({c % 23,  // seven bodies have none
                          {1e6 * share(random), 1e6 * share(random), 1e4 * share(random),
                           1e3 * share(random), 1e3 * share(random), 1e7 * share(random)},
                          vector().normalized(),
                          vector(),
                          100.0 * share(random)});
    ContactStepBound bound(bodies);
    for (const RandomContact& c : contacts)
      bound.add(c.body, c.resistance, c.normal, c.arm, c.other_mass);
    EXPECT_NEAR(bound.steps(false).springs / by_displacements(bodies, contacts, false), 1.0, 1e-9);
    EXPECT_NEAR(bound.steps(false).with_dashpots / by_displacements(bodies, contacts, true), 1.0,
                1e-9);
  }
}

TEST(ContactStepBound, DashpotsAlone) {
  // 2 dt C <= 4 M with twice the dashpot, as for a pair of equal masses.
  ContactStepBound bound({kMassPoint});
  bound.add(0, {0.0, 0.0, 0.0, 300.0, 0.0}, Vec3::UnitX(), Vec3::Zero(), kMass);
  EXPECT_NEAR(bound.steps(false).with_dashpots / (2.0 * kMass / (2.0 * 300.0)), 1.0, 1e-12);
  EXPECT_TRUE(std::isinf(bound.steps(false).springs));
}

TEST(ContactStepBound, GroupsAreToldApart) {
  std::vector<ContactStepBound::Body> bodies{kMassPoint, kMassPoint};
  bodies[1].joined = true;
  ContactStepBound bound(bodies);
  bound.add(1, spring(0.0), Vec3::UnitX(), Vec3::Zero(), kMass);
  EXPECT_TRUE(std::isinf(bound.steps(false).springs));
  EXPECT_NEAR(bound.steps(true).springs / (2.0 / std::sqrt(2.0 * kStiffness / kMass)), 1.0, 1e-12);
}

TEST(ContactStepBound, NoContactNoBound) {
  EXPECT_TRUE(std::isinf(ContactStepBound({kMassPoint}).steps(false).springs));
  EXPECT_TRUE(std::isinf(ContactStepBound({kMassPoint}).steps(false).with_dashpots));
}

}  // namespace
}  // namespace muckpile
