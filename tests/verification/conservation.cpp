// SPDX-License-Identifier: GPL-2.0-or-later
// What an undamped, unbroken body keeps: energy, momentum, angular momentum; at rest and in spin.
// Scope: leapfrog of the verification programs, 10,000 steps of half the stable one.
#include <algorithm>
#include <cmath>
#include <random>

#include "framework/block_run.h"
#include "framework/cases.h"
#include "framework/rock_samples.h"

namespace muckpile::verification {
namespace {

constexpr int kSteps = 10000, kWindow = 1000;
constexpr double kDrift = 1e-6;  // of the issue: per 10,000 steps

struct Momenta {
  Vec3 linear = Vec3::Zero(), angular = Vec3::Zero();
  double linear_size = 0.0, angular_size = 0.0;  ///< sums of the sizes of the parts
};

Momenta momenta(const BlockRun& run) {
  Momenta sum;
  for (std::size_t b = 0; b < run.size(); ++b) {
    const BlockState& s = run.block(b);
    const Vec3 p = run.mass(b) * s.velocity;
    const Vec3 orbit = s.centre.cross(p);
    const Vec3 own = s.rotation * run.inertia(b) * s.rotation.transpose() * s.spin;
    sum.linear += p;
    sum.angular += orbit + own;
    sum.linear_size += p.norm();
    sum.angular_size += orbit.norm() + own.norm();
  }
  return sum;
}

struct Change {
  double energy, linear, angular;  ///< over the start's
};

/// The energy that leapfrog keeps to rounding where forces are linear: elastic energy at a step and
/// the product of the velocities half a step before and after. Kinetic energy at the step instead
/// would swing by (omega dt)^2/8 as modes change hands.
double leapfrog_energy(const BlockRun& run, double dt) {
  double kicked = 0.0;
  for (std::size_t b = 0; b < run.size(); ++b) {
    const Mat3& r = run.block(b).rotation;
    const Vec3 torque = r.transpose() * run.torque(b);
    kicked +=
        run.force(b).squaredNorm() / run.mass(b) + torque.dot(run.inertia(b).inverse() * torque);
  }
  return run.kinetic_energy() + run.elastic_energy() - 0.125 * dt * dt * kicked;
}

Change change(BlockRun& run) {
  run.compute();
  const Momenta start = momenta(run);
  const double dt = 0.5 * run.stable_step();
  double first = 0.0, last = 0.0, linear = 0.0, angular = 0.0;
  for (int n = 0; n < kSteps; ++n) {
    run.step(dt);
    const double energy = leapfrog_energy(run, dt) / kWindow;
    if (n < kWindow) first += energy;
    if (n >= kSteps - kWindow) last += energy;
    if (n % 100 != 99) continue;
    const Momenta now = momenta(run);
    linear = std::max(linear, (now.linear - start.linear).norm() / start.linear_size);
    angular = std::max(angular, (now.angular - start.angular).norm() / start.angular_size);
  }
  return {last / first - 1.0, linear, angular};
}

void report_change(Report& report, const std::string& name, BlockRun& run) {
  const Change c = change(run);
  report.at_most({name, "energy drift over 10,000 steps", "", "conservation"}, c.energy, kDrift);
  // A sum of some hundred parts, in 10,000 steps of some thousand roundings of 1e-16.
  report.at_most({name, "momentum, change over the sum of its parts", "", "conservation"}, c.linear,
                 1e-12);
  report.at_most({name, "angular momentum, change over the sum of its parts", "", "conservation"},
                 c.angular, 1e-12);
}

/// Every block gets a velocity of up to `speed` [m/s] and a spin of up to `speed` per metre.
void shake(BlockRun& run, double speed, const Vec3& spin) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  const auto vector = [&] { return Vec3(unit(random), unit(random), unit(random)); };
  for (std::size_t b = 0; b < run.size(); ++b) {
    const Vec3 velocity = speed * vector() + spin.cross(run.start(b));
    run.set_motion(b, velocity, speed * vector() + spin);
  }
}

BlockRun free_body(const RockSample& sample, double nu) {
  return BlockRun(sample.blocks, {rock(nu)}, [](const Vec3&) { return Wall::free; });
}

void vibrating(Report& report) {
  for (const double nu : {0.0, 0.25, 0.45}) {
    BlockRun run = free_body(uniform_rock({5, 5, 5}), nu);
    shake(run, 0.01, Vec3::Zero());
    report_change(report, "free cube of 125 blocks, shaken, nu " + spelled(nu), run);
  }
}

void spinning(Report& report) {
  for (const double speed : {0.0, 0.1}) {
    BlockRun run = free_body(uniform_rock({3, 3, 3}), 0.25);
    shake(run, speed, {20.0, 5.0, -10.0});
    report_change(report,
                  speed > 0.0 ? "fragment of 27 blocks in spin of 23 rad/s, shaken"
                              : "fragment of 27 blocks in spin of 23 rad/s",
                  run);
  }
}

const Cases kCases = {{"vibrating", vibrating}, {"spinning", spinning}};

}  // namespace
}  // namespace muckpile::verification

int main(int argc, char** argv) {
  return muckpile::verification::run_case("conservation", muckpile::verification::kCases, argc,
                                          argv);
}
