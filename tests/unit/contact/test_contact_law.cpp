// SPDX-License-Identifier: GPL-2.0-or-later
// The contact law against closed forms: impact, sliding, rolling, energy.
// Scope: two spheres, or one on a plane-like large one, moved by a leapfrog in the test.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "args/input_error.h"
#include "contact/contact_law.h"

namespace muckpile {
namespace {

constexpr double kMass = 3.0;    // of each of two equal blocks [kg]
constexpr double kRadius = 0.1;  // of each of two equal spheres [m]
const Vec3 kNormal(1, 0, 0);
using One = VectorOf<std::experimental::simd<double, std::experimental::simd_abi::scalar>>;

ContactMotion motion_of(double overlap, const Vec3& relative_velocity,
                        const Vec3& relative_spin = Vec3::Zero()) {
  return {kNormal, overlap, kRadius, kRadius, 0.5 * kMass, relative_velocity, relative_spin};
}

struct Impact {
  double speed_after;   // [m/s]
  double duration;      // while the force acts [s]
  double peak_force;    // [N]
  double damping_loss;  // [J]
};

// Head-on impact of the two equal spheres: one degree of freedom, reduced mass kMass / 2.
Impact impact(const ContactLaw& law, double speed, double dt) {
  ContactState state;
  double overlap = 0.0, v = speed;
  Impact out{0, 0, 0, 0};
  bool touched = false;
  for (int step = 0; step < 2'000'000; ++step) {
    overlap += v * dt;
    if (overlap <= 0.0 && touched) break;
    const ContactMotion m = motion_of(overlap, Vec3(v, 0, 0));
    if (!touched) state = ContactLaw::begin_contact(m, dt);
    touched = true;
    const ContactResponse r = law.evaluate(m, dt, state);
    const double force = -r.force_on_first.x();
    out.peak_force = std::max(out.peak_force, force);
    out.damping_loss += r.damping_loss;
    if (force > 0.0) out.duration += dt;
    v -= force / (0.5 * kMass) * dt;
  }
  out.speed_after = -v;
  return out;
}

class Restitution : public testing::TestWithParam<std::tuple<NormalModel, double>> {};

TEST_P(Restitution, IsTheAskedShareOfTheSpeedBeforeAnImpact) {
  const auto [model, restitution] = GetParam();
  ContactParameters p;
  p.model = model;
  p.restitution = restitution;
  for (const double speed : {0.1, 5.0}) {  // independent of the speed
    const Impact result = impact(ContactLaw(p), speed, 1e-7);
    // 1 %: the acceptance of the style; the scheme's own error at this step is below 0.2 %.
    EXPECT_NEAR(result.speed_after / speed, restitution, 0.01 * restitution);
    // The dashpot took what is missing; first-order accounting, about 1e4 steps per impact.
    const double lost = 0.25 * kMass * (speed * speed - result.speed_after * result.speed_after);
    EXPECT_NEAR(result.damping_loss, lost, 0.002 * 0.25 * kMass * speed * speed);
  }
}

INSTANTIATE_TEST_SUITE_P(BothModels, Restitution,
                         testing::Combine(testing::Values(NormalModel::hertz, NormalModel::linear),
                                          testing::Values(1.0, 0.8, 0.5, 0.2, 0.08)));

/// Two equal blocks of one sphere each that meet at an angle, by the engine's leapfrog with `dt`;
/// the first step in contact has gone the share `inside` of a step. Gives the speeds at which the
/// points part over that of the impact, along and across the normal.
struct Rebound {
  double along, across;
};
Rebound rebound(const ContactLaw& law, double speed, double angle, double dt, double inside) {
  constexpr double kTurning = 2.0 / (0.4 * kMass);  // r^2/I of both, I = 2/5 m r^2 [1/kg]
  Vec3 v = speed * Vec3(std::cos(angle), std::sin(angle), 0);
  double overlap = (inside - 1.0) * v.x() * dt;
  ContactState state;
  for (bool touched = false;; touched = true) {
    overlap += v.x() * dt;
    if (overlap <= 0.0) return {-v.x() / speed, v.y() / speed};
    const ContactMotion m = motion_of(overlap, v);
    if (!touched) state = ContactLaw::begin_contact(m, dt);
    const Vec3 force = law.evaluate(m, dt, state).force_on_first;
    v += dt * Vec3(force.x() * 2.0 / kMass, force.y() * (2.0 / kMass + kTurning), 0);
  }
}

struct ReboundError {
  double mean;  // of the rebound along the normal, over that of the impact [-]
  double rms;   // of the whole rebound
};
/// Against very short steps, over where in a step the contact begins.
ReboundError rebound_error(const ContactLaw& law, double angle, double duration, int steps) {
  constexpr double kSpeed = 20.0;  // [m/s]; the law has no speed of its own
  constexpr int kPhases = 64;
  const Rebound exact = rebound(law, kSpeed, angle, duration / 20000.0, 0.5);
  ReboundError error{0.0, 0.0};
  for (int k = 0; k < kPhases; ++k) {
    const Rebound now = rebound(law, kSpeed, angle, duration / steps, (k + 0.5) / kPhases);
    const double along = now.along - exact.along, across = now.across - exact.across;
    error.mean += along / kPhases;
    error.rms += (along * along + across * across) / kPhases;
  }
  return {error.mean, std::sqrt(error.rms)};
}

/// What steps_per_contact of the inputs stands on. The dashpot lags half a step, so the mean error
/// goes with the step; from 8 steps on it is what a restitution known to one digit leaves open.
TEST(ContactLaw, EightStepsPerCollisionKeepTheRebound) {
  ContactParameters p;
  p.youngs_modulus = 2.5e7;
  p.friction = 0.7;
  // Hertz at 20 m/s, as in contact/collision_time.h.
  const double mass = 0.5 * kMass, radius = 0.5 * kRadius;
  const double modulus = p.youngs_modulus / (2.0 * (1.0 - p.poisson_ratio * p.poisson_ratio));
  const double duration = 2.87 * std::pow(mass * mass / (radius * modulus * modulus * 20.0), 0.2);
  for (const double restitution : {0.2, 0.5, 0.9}) {
    p.restitution = restitution;
    const ContactLaw law(p);
    for (const int degrees : {0, 30, 60}) {
      std::printf("restitution %.1f, %2d degrees, mean and rms error:", restitution, degrees);
      for (const int steps : {5, 8, 10, 15, 30}) {
        const ReboundError error =
            rebound_error(law, degrees * std::numbers::pi / 180.0, duration, steps);
        std::printf(" %d: %+.4f %.4f", steps, error.mean, error.rms);
        if (steps < 8) continue;
        EXPECT_LT(std::abs(error.mean), 0.25 / steps) << restitution << ' ' << degrees;
        if (restitution != 0.5) continue;  // that of the inputs
        EXPECT_LT(error.rms, 0.3 / steps) << degrees;
      }
      std::printf("\n");
    }
  }
}

TEST(ContactLaw, DampingRatioInvertsRestitution) {
  EXPECT_DOUBLE_EQ(damping_ratio_for(1.0), 0.0);
  EXPECT_NEAR(restitution_of(1.0), std::exp(-2.0), 1e-12);
  // By hand: z = 1/2 gives exp(-acos(1/2) / sqrt(3/4)) = exp(-(pi/3) * 2/sqrt(3)) = 0.29846
  EXPECT_NEAR(restitution_of(0.5), std::exp(-2.0 * std::numbers::pi / (3.0 * std::sqrt(3.0))),
              1e-12);
  for (double e = 0.05; e < 1.0; e += 0.05)
    EXPECT_NEAR(restitution_of(damping_ratio_for(e)), e, 1e-9);
}

TEST(ContactLaw, HertzImpactHasItsClosedFormDurationAndPeakForce) {
  ContactParameters p;
  p.restitution = 1.0;
  const double speed = 2.0;
  const Impact result = impact(ContactLaw(p), speed, 1e-7);
  // k = 4/3 E* sqrt(R*), R* = 0.05 m, E* = 5e8 / (2 (1 - 1/16)) = 2.6667e8 Pa
  const double k = 4.0 / 3.0 * 5e8 / (2.0 * (1.0 - 0.0625)) * std::sqrt(0.05);
  const double m = 0.5 * kMass;
  const double deepest = std::pow(1.25 * m * speed * speed / k, 0.4);
  // Johnson, Contact Mechanics (1985), eq. 11.24: T = 2.943 deepest / speed
  EXPECT_NEAR(result.duration, 2.9432 * deepest / speed, 0.002 * result.duration);
  EXPECT_NEAR(result.peak_force, k * std::pow(deepest, 1.5), 0.002 * result.peak_force);
}

TEST(ContactLaw, LinearImpactLastsHalfAPeriod) {
  ContactParameters p;
  p.model = NormalModel::linear;
  p.restitution = 1.0;
  const Impact result = impact(ContactLaw(p), 2.0, 1e-7);
  // k = E pi r^2 / (2 r) = 5e8 * pi * 0.1 / 2
  const double k = 5e8 * std::numbers::pi * kRadius / 2.0;
  const double m = 0.5 * kMass;
  EXPECT_NEAR(result.duration, std::numbers::pi * std::sqrt(m / k), 0.002 * result.duration);
  EXPECT_NEAR(result.peak_force, 2.0 * std::sqrt(k * m), 0.002 * result.peak_force);
}

TEST(ContactLaw, NormalStiffnessIsTheSlopeOfTheForce) {
  for (const NormalModel model : {NormalModel::hertz, NormalModel::linear}) {
    ContactParameters p;
    p.model = model;
    const ContactLaw law(p);
    ContactState a, b;
    const double h = 1e-7;
    const double f0 = law.evaluate(motion_of(1e-3 - h, Vec3::Zero()), 0, a).force_on_first.x();
    const double f1 = law.evaluate(motion_of(1e-3 + h, Vec3::Zero()), 0, b).force_on_first.x();
    const double slope = law.normal_stiffness(kRadius, kRadius, 1e-3);
    EXPECT_NEAR((f0 - f1) / (2 * h), slope, 1e-6 * slope);  // central difference, h^2
  }
}

TEST(ContactLaw, TheContactNeverPulls) {
  ContactState state;
  const ContactLaw law{ContactParameters{}};
  const ContactResponse r = law.evaluate(motion_of(1e-4, Vec3(-50, 0, 0)), 1e-6, state);
  EXPECT_EQ(r.force_on_first.x(), 0.0);
}

// A block pressed with a constant overlap slides: deceleration mu N / m, and the friction loss is
// the kinetic energy.
TEST(ContactLaw, SlidingBlockDeceleratesByFrictionTimesNormalForce) {
  for (const NormalModel model : {NormalModel::hertz, NormalModel::linear}) {
    ContactParameters p;
    p.model = model;
    p.friction = 0.3;
    const ContactLaw law(p);
    ContactState state;
    const double overlap = 1e-3, start = 40.0;  // [m], [m/s]
    double v = start, lost = 0.0, normal_force = 0.0, time = 0.0;
    const double dt = 1e-7, m = 0.5 * kMass;
    for (; time < 8e-4; time += dt) {
      const ContactResponse r = law.evaluate(motion_of(overlap, Vec3(0, v, 0)), dt, state);
      normal_force = -r.force_on_first.x();
      v += r.force_on_first.y() / m * dt;
      lost += r.friction_loss + r.damping_loss;
    }
    const double expected = start - p.friction * normal_force / m * time;
    ASSERT_GT(start - expected, 0.3);
    // The spring loads up over the first 9e-6 of 8e-4 s at half the force: 0.6 % of the drop.
    EXPECT_NEAR(v, expected, 0.01 * (start - expected));
    EXPECT_NEAR(lost, 0.5 * m * (start * start - v * v), 0.01 * 0.5 * m * (start * start - v * v));
  }
}

TEST(ContactLaw, StickingSpringStoresTheWorkDoneOnIt) {
  ContactParameters p;
  p.restitution = 1.0;  // no dashpot
  p.friction = 10.0;    // sticks
  const ContactLaw law(p);
  ContactState state;
  const double overlap = 1e-4, speed = 1e-2, dt = 1e-6;
  const double rest = law.evaluate(motion_of(overlap, Vec3::Zero()), dt, state).elastic_energy;
  double work = 0.0, stored = 0.0, slip = 0.0, last = 0.0;
  for (int step = 0; step < 1000; ++step) {  // 10 micrometres
    const ContactResponse r = law.evaluate(motion_of(overlap, Vec3(0, speed, 0)), dt, state);
    work -= 0.5 * (last + r.force_on_first.y()) * speed * dt;  // trapezoid, exact for a line
    last = r.force_on_first.y();
    stored = r.elastic_energy - rest;
    slip += r.friction_loss;
  }
  // k_t = 8 G* sqrt(R* overlap), G* = E / (4 (1 + nu) (2 - nu)); energy k_t s^2 / 2
  const double k_t = 8.0 * 5e8 / (4.0 * 1.25 * 1.75) * std::sqrt(0.05 * overlap);
  EXPECT_NEAR(stored, 0.5 * k_t * 1e-10, 1e-9 * stored);  // rounding of 1000 additions
  EXPECT_NEAR(work, stored, 1e-9 * stored);
  EXPECT_NEAR(slip, 0.0, 1e-12 * stored);
}

// Closed path in overlap and slide, both directions round: an elastic contact may lose energy in
// such a cycle (its tangential stiffness depends on the overlap), it must never give any.
TEST(ContactLaw, NoElasticCycleGivesEnergy) {
  ContactParameters p;
  p.restitution = 1.0;
  p.friction = 10.0;
  const ContactLaw law(p);
  for (const double direction : {1.0, -1.0}) {
    ContactState state;
    double work_on_contact = 0.0;
    const int steps = 20000;
    const double dt = 1e-6;
    double overlap = 1e-4;
    (void)law.evaluate(motion_of(overlap, Vec3::Zero()), dt, state);
    for (int k = 0; k < 3 * steps; ++k) {
      const double angle = direction * 2.0 * std::numbers::pi * (k + 0.5) / steps;
      const double rate = direction * 2.0 * std::numbers::pi / (steps * dt);
      const Vec3 v(-0.5e-4 * std::sin(angle) * rate, 0.2e-4 * std::cos(angle) * rate, 0.0);
      overlap += v.x() * dt;
      const ContactResponse r = law.evaluate(motion_of(overlap, v), dt, state);
      work_on_contact -= r.force_on_first.dot(v) * dt;
    }
    const double k_t = 8.0 * 5e8 / (4.0 * 1.25 * 1.75) * std::sqrt(0.05 * 1e-4);
    const double scale = 0.5 * k_t * 0.2e-4 * 0.2e-4;  // tangential energy of one stroke [J]
    EXPECT_GT(work_on_contact, -1e-3 * scale) << "direction " << direction;  // first-order sum
  }
}

TEST(ContactLaw, ADeepStartCarriesNoForceAndGivesNoEnergy) {
  ContactParameters p;
  p.restitution = 1.0;
  const ContactLaw law(p);
  const double initial = 2e-3, dt = 1e-7;
  ContactState state = ContactLaw::begin_contact(motion_of(initial, Vec3::Zero()), dt);
  EXPECT_EQ(law.evaluate(motion_of(initial, Vec3::Zero()), dt, state).force_on_first.norm(), 0.0);
  // Pressed at 1 m/s from there: comes back with 1 m/s, not faster.
  double overlap = initial, v = 1.0;
  while (overlap > 0.0) {
    overlap += v * dt;
    if (overlap <= 0.0) break;
    v += law.evaluate(motion_of(overlap, Vec3(v, 0, 0)), dt, state).force_on_first.x() /
         (0.5 * kMass) * dt;
  }
  EXPECT_NEAR(-v, 1.0, 1e-3);             // O(dt) of some 1e4 steps
  EXPECT_LT(state.overlap_offset, 1e-6);  // shrank with the overlap
}

TEST(ContactLaw, OffsetOnlyForSpheresThatOverlappedAStepAgo) {
  const double dt = 1e-5;
  EXPECT_EQ(ContactLaw::begin_contact(motion_of(9e-6, Vec3(1, 0, 0)), dt).overlap_offset, 0.0);
  EXPECT_EQ(ContactLaw::begin_contact(motion_of(11e-6, Vec3(1, 0, 0)), dt).overlap_offset, 11e-6);
}

// A wheel that spins on the spot against the rolling spring: below the limit torque it swings
// with sqrt(k_r / I), above it the spin falls by mu_r R* N / I.
TEST(ContactLaw, SpinDecaysByTheRollingLimitTorque) {
  ContactParameters p;
  p.rolling_friction = 0.1;
  p.friction = 0.0;
  const ContactLaw law(p);
  ContactState state;
  const double inertia = 0.02, dt = 1e-6, overlap = 1e-3;
  double spin = 30.0, lost = 0.0, normal_force = 0.0, time = 0.0;
  for (; time < 5e-3; time += dt) {
    const ContactResponse r =
        law.evaluate(motion_of(overlap, Vec3::Zero(), Vec3(0, 0, spin)), dt, state);
    normal_force = -r.force_on_first.x();
    spin += r.torque_on_first.z() / inertia * dt;
    lost += r.friction_loss;
  }
  const double expected = 30.0 - 0.1 * 0.05 * normal_force / inertia * time;
  ASSERT_LT(expected, 29.0);
  EXPECT_NEAR(spin, expected, 0.01 * (30.0 - expected));  // the spring loads up first
  const double spent = 0.5 * inertia * (30.0 * 30.0 - spin * spin);
  EXPECT_NEAR(lost, spent, 0.01 * spent);
}

TEST(ContactLaw, SpinAboutTheNormalMeetsNoResistance) {
  ContactState state;
  const ContactLaw law{ContactParameters{}};
  const ContactResponse r =
      law.evaluate(motion_of(1e-4, Vec3::Zero(), Vec3(20, 0, 0)), 1e-5, state);
  EXPECT_EQ(r.torque_on_first.norm(), 0.0);
}

TEST(ContactLaw, SpringsTurnWithTheTangentPlaneAndKeepTheirLength) {
  const Vec3 spring(0.0, 3e-6, 4e-6);
  const Vec3 normal = Vec3(1.0, 0.2, -0.1).normalized();
  const auto turn = [&](const Vec3& v) { return turned_into_plane(One(v), One(normal)).at(0); };
  const Vec3 turned = turn(spring);
  EXPECT_NEAR(turned.dot(normal), 0.0, 1e-20);
  EXPECT_NEAR(turned.norm(), 5e-6, 1e-18);
  EXPECT_EQ(turn(2e-6 * normal).norm(), 0.0);
  EXPECT_EQ(turn(Vec3::Zero()).norm(), 0.0);
}

TEST(ContactLaw, RefusesValuesOutOfRange) {
  const auto refused = [](auto change) {
    ContactParameters p;
    change(p);
    EXPECT_THROW((void)ContactLaw(p), InputError);
  };
  refused([](ContactParameters& p) { p.youngs_modulus = 0.0; });
  refused([](ContactParameters& p) { p.youngs_modulus = std::nan(""); });
  refused([](ContactParameters& p) { p.poisson_ratio = 0.5; });
  refused([](ContactParameters& p) { p.restitution = 0.04; });
  refused([](ContactParameters& p) { p.restitution = 1.01; });
  refused([](ContactParameters& p) { p.friction = -0.1; });
  refused([](ContactParameters& p) { p.rolling_friction = -0.1; });
}

TEST(ContactLaw, StableStepIsAFifthOfTheContactsTimeScale) {
  // k = 2 E* sqrt(0.05) r with E* = 2.6667e8 Pa, r = 0.1 m: 1.1926e7 N/m; m = 3 kg
  const ContactLaw law{ContactParameters{}};
  EXPECT_NEAR(law.stable_time_step(3.0, 0.1), 0.2 * std::sqrt(3.0 / 1.19257e7), 1e-8);
  // k = E pi r with E = 5e8 Pa: 1.5708e8 N/m; of two equal blocks half of that at half the mass
  ContactParameters linear;
  linear.model = NormalModel::linear;
  EXPECT_NEAR(ContactLaw(linear).stable_time_step(3.0, 0.1), 0.2 * std::sqrt(3.0 / 1.570796e8),
              1e-8);
}

}  // namespace
}  // namespace muckpile
