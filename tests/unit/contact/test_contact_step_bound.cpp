// SPDX-License-Identifier: GPL-2.0-or-later
// The bound on the time step is exact where it can be, and an upper bound on stiffness elsewhere.
// Scope: masses on springs with dashpots, integrated with the engine's leapfrog.
#include <gtest/gtest.h>

#include <array>
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

TEST(ContactStepBound, IsTheLimitOfTwoMassesOnOneSpringWithDashpot) {
  for (const double damping : {0.0, 300.0, 2000.0}) {
    ContactStepBound bound(2);
    for (const std::size_t body : {0u, 1u}) bound.add(body, kStiffness, damping, 1.0 / kMass);
    EXPECT_LE(swing(damping, 0.995 * bound.step()), 1.1e-2) << damping;
    EXPECT_GT(swing(damping, 1.01 * bound.step()), 1.0) << damping;
  }
}

TEST(ContactStepBound, UndampedPairByHand) {
  ContactStepBound bound(2);
  for (const std::size_t body : {0u, 1u}) bound.add(body, kStiffness, 0.0, 1.0 / kMass);
  EXPECT_DOUBLE_EQ(bound.step(), 2.0 / std::sqrt(2.0 * kStiffness / kMass));
}

TEST(ContactStepBound, ChainOfMassesIsWithinASmallMargin) {
  // Infinite chain: omega^2 = 4 k / m; each mass has two contacts.
  ContactStepBound bound(1);
  bound.add(0, kStiffness, 0.0, 1.0 / kMass);
  bound.add(0, kStiffness, 0.0, 1.0 / kMass);
  EXPECT_DOUBLE_EQ(bound.step(), 2.0 / std::sqrt(4.0 * kStiffness / kMass));
}

TEST(ContactStepBound, NoContactNoBound) { EXPECT_TRUE(std::isinf(ContactStepBound(5).step())); }

}  // namespace
}  // namespace muckpile
