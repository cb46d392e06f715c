// SPDX-License-Identifier: GPL-2.0-or-later
// A prism of jointed rock between two smooth, rigid plates, under pressure on its sides.
// Scope: see the header.
#include "framework/press.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace muckpile::verification {
namespace {

constexpr double kTransits = 40.0;  // of a wave through the prism, from 0 to the expected strength
constexpr double kDegree = std::numbers::pi / 180.0;

/// Smooth plates: what is behind them mirrors the prism.
WallRule plates(const Vec3& box) {
  return [=](const Vec3& at) {
    const double slack = 1e-6 * box.z();
    return at.z() < slack || at.z() > box.z() - slack ? Wall::even : Wall::free;
  };
}

}  // namespace

JointParameters weak_rock() {
  JointParameters p = rock(0.25);
  p.tension = 2e6;
  p.cohesion = 4e6;
  p.friction_angle = 50.0 * kDegree;
  p.residual_friction_angle = 35.0 * kDegree;
  p.damping = 0.1;  // vibration dies down, the slow strain is not slowed: 1e-4 of the strength
  p.contact_damping = 0.1;
  return p;
}

Press::Press(const RockSample& sample, const JointParameters& rock, double confinement)
    : rock_(rock),
      run_(sample.blocks, {rock}, plates(sample.box)),
      height_(sample.box.z()),
      confinement_(confinement) {
  for (BoundaryFace& face : run_.network().faces()) face.hole = 0;  // the sides
  run_.compute();
  dt_ = 0.4 * run_.stable_step();
  if (confinement_ == 0.0) return;
  // Pressure from all sides strains the prism alike in all directions.
  const double squeezed = confinement_ * (1.0 - 2.0 * rock_.poisson_ratio) / rock_.youngs_modulus;
  const double speed = std::sqrt(rock_.youngs_modulus / rock_.density);
  const int steps = static_cast<int>(kTransits * height_ / speed / dt_);
  for (int n = 1; n <= steps; ++n) {
    const double share = 0.5 * (1.0 - std::cos(std::numbers::pi * n / steps));
    step(-share * squeezed, share * confinement_);
  }
}

void Press::step(double strain, double pressure) {
  strain_ = strain;
  Mat3 average = Mat3::Zero();
  average(2, 2) = strain;
  run_.set_average_strain(average);
  for (BoundaryFace& face : run_.network().faces()) face.pressure = pressure;
  run_.step(dt_);
}

double Press::pull() {
  start(1.0, rock_.tension);
  drive(true);
  return peak_;
}

/// The strength of rock without joints after Mohr and Coulomb sets the rate.
double Press::squeeze() {
  const double cone = std::tan(0.25 * std::numbers::pi + 0.5 * rock_.friction_angle);
  start(-1.0, 2.0 * rock_.cohesion * cone + confinement_ * (cone * cone - 1.0));
  drive(true);
  return peak_;
}

void Press::squeeze_on() { drive(false); }

/// Plates at a steady rate, and the prism with them, so that no wave is sent.
void Press::start(double direction, double expected) {
  const double transit = height_ / std::sqrt(rock_.youngs_modulus / rock_.density);  // [s]
  direction_ = direction;
  expected_ = expected;
  rate_ = direction * expected / rock_.youngs_modulus / (kTransits * transit);
  start_strain_ = strain_;
  for (std::size_t b = 0; b < run_.size(); ++b) {
    const Vec3& x = run_.start(b);
    const double nu = rock_.poisson_ratio;
    run_.set_motion(b, rate_ * Vec3(-nu * x.x(), -nu * x.y(), x.z()), Vec3::Zero());
  }
}

void Press::drive(bool until_it_fails) {
  const double last = 3.0 * expected_ / rock_.youngs_modulus;
  double strained = std::abs(strain_ - start_strain_), now = peak_;
  const auto failed = [&] { return peak_ > 0.1 * expected_ && now < 0.9 * peak_; };
  while (strained < last && !(until_it_fails && failed())) {
    step(strain_ + rate_ * dt_, confinement_);
    strained = std::abs(strain_ - start_strain_);
    now = direction_ * run_.average_stress()(2, 2);
    peak_ = std::max(peak_, now);
    path_.emplace_back(strained, now);
  }
}

}  // namespace muckpile::verification
