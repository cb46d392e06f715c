// SPDX-License-Identifier: GPL-2.0-or-later
// The bound on the time step is exact where it can be, and an upper bound on stiffness elsewhere.
// Scope: masses on springs with dashpots, integrated with the engine's leapfrog.
#include <gtest/gtest.h>

#include <cmath>

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
const ContactStepBound::Body kMassPoint{kMass, 1e12 * Mat3::Identity()};

ContactResistance spring(double damping) { return {kStiffness, 0.0, 0.0, damping, 0.0}; }

TEST(ContactStepBound, IsTheLimitOfTwoMassesOnOneSpringWithDashpot) {
  for (const double damping : {0.0, 300.0, 2000.0}) {
    ContactStepBound bound;
    for (const std::size_t body : {0u, 1u})
      bound.add(body, kMassPoint, spring(damping), Vec3::UnitX(), Vec3::Zero(), kMass);
    EXPECT_LE(swing(damping, 0.995 * bound.step()), 1.1e-2) << damping;
    EXPECT_GT(swing(damping, 1.01 * bound.step()), 1.0) << damping;
  }
}

TEST(ContactStepBound, UndampedPairByHand) {
  ContactStepBound bound;
  bound.add(0, kMassPoint, spring(0.0), Vec3::UnitX(), Vec3::Zero(), kMass);
  EXPECT_NEAR(bound.step() / (2.0 / std::sqrt(2.0 * kStiffness / kMass)), 1.0, 1e-12);
}

TEST(ContactStepBound, UnequalPairIsWithinATenth) {
  // omega^2 = k (1/m + 1/M); the light body's part of the bound is k (1/m + 1/sqrt(m M)).
  for (const double ratio : {1.0, 4.0, 100.0, 1e4}) {
    ContactStepBound bound;
    ContactStepBound::Body heavy = kMassPoint;
    heavy.mass = ratio * kMass;
    bound.add(0, kMassPoint, spring(0.0), Vec3::UnitX(), Vec3::Zero(), heavy.mass);
    bound.add(1, heavy, spring(0.0), Vec3::UnitX(), Vec3::Zero(), kMass);
    const double exact = 2.0 / std::sqrt(kStiffness / kMass * (1.0 + 1.0 / ratio));
    EXPECT_LE(bound.step(), exact * (1.0 + 1e-12)) << ratio;
    EXPECT_GE(bound.step(), 0.9 * exact) << ratio;
  }
}

TEST(ContactStepBound, ContactsAcrossEachOtherDoNotAddUp) {
  // Two contacts along each axis: omega^2 = 2 x 2 k / m, as for those of one axis alone. With both
  // of them in a chain that is also the exact value.
  ContactStepBound bound;
  for (int axis = 0; axis < 3; ++axis)
    for (int side = 0; side < 2; ++side)
      bound.add(0, kMassPoint, spring(0.0), Vec3::Unit(axis), Vec3::Zero(), kMass);
  EXPECT_NEAR(bound.step() / (2.0 / std::sqrt(4.0 * kStiffness / kMass)), 1.0, 1e-12);
}

TEST(ContactStepBound, TurningCounts) {
  // Tangential spring k_t at arm r: omega^2 = 2 k_t (1/m + r^2/I), here 2 k_t (1/m + 2/m); the
  // rolling spring acts beside it, about the other axis 2 k_r/I.
  const double inertia = 0.5 * kMass;
  const ContactStepBound::Body body{kMass, inertia * Mat3::Identity()};
  ContactStepBound sliding;
  sliding.add(0, body, {0.0, kStiffness, 0.0, 0.0, 0.0}, Vec3::UnitX(), Vec3::UnitX(), kMass);
  EXPECT_NEAR(sliding.step() / (2.0 / std::sqrt(6.0 * kStiffness / kMass)), 1.0, 1e-12);
  ContactStepBound rolling;
  rolling.add(0, body, {0.0, 0.0, kStiffness, 0.0, 0.0}, Vec3::UnitX(), Vec3::UnitX(), kMass);
  EXPECT_NEAR(rolling.step() / (2.0 / std::sqrt(2.0 * kStiffness / inertia)), 1.0, 1e-12);
}

TEST(ContactStepBound, TheWorstBodyCounts) {
  for (const bool light_first : {false, true}) {
    ContactStepBound bound;
    ContactStepBound::Body light = kMassPoint;
    light.mass = 0.01 * kMass;
    bound.add(light_first ? 0 : 1, light, spring(50.0), Vec3::UnitZ(), Vec3::Zero(), light.mass);
    bound.add(light_first ? 1 : 0, kMassPoint, spring(50.0), Vec3::UnitZ(), Vec3::Zero(), kMass);
    const double omega = std::sqrt(2.0 * kStiffness / light.mass),
                 zeta = 50.0 / (light.mass * omega);
    EXPECT_NEAR(bound.step() / (2.0 / omega * (std::sqrt(1.0 + zeta * zeta) - zeta)), 1.0, 1e-3);
  }
}

TEST(ContactStepBound, NoContactNoBound) { EXPECT_TRUE(std::isinf(ContactStepBound().step())); }

}  // namespace
}  // namespace muckpile
