// SPDX-License-Identifier: GPL-2.0-or-later
// Rock with a set of compliant parallel joints: how much slower waves run across them.
// Scope: standing waves of 20 m, 16 joints to a wavelength; unbroken, undamped.
#include <cmath>
#include <numbers>

#include "bond/build/joint_plane.h"
#include "framework/cases.h"
#include "framework/rock_samples.h"
#include "framework/standing_wave.h"

namespace muckpile::verification {
namespace {

constexpr double kRatio = 0.25;  // Poisson's
constexpr double kSpacing = 1.25;
constexpr double kTolerance = 0.02;  // slabs between joints are one block thick or two
constexpr double kStepShare = 0.5, kPeriods = 2.0;
const Vec3 kBox(10.0, 4.0, 4.0);  // holds half a wavelength

/// Joints and rock in series: over a spacing the stress t closes the rock by t s / M and the joint
/// by t / k, so that 1 / M_effective = 1 / M + 1 / (k s), at wavelengths much longer than s.
double effective_modulus(double modulus, double stiffness) {
  return 1.0 / (1.0 / modulus + 1.0 / (stiffness * kSpacing));
}

/// The phase speed at the wave number q of rock with such joints (Bloch waves; k from the
/// displacement discontinuity): cos(q s) = cos(w s / c) - w Z / (2 k) sin(w s / c).
double exact_speed(double modulus, double density, double stiffness, double q) {
  const double c = std::sqrt(modulus / density), impedance = density * c;
  const auto excess = [&](double w) {
    const double x = w * kSpacing / c;
    return std::cos(x) - 0.5 * w * impedance / stiffness * std::sin(x) - std::cos(q * kSpacing);
  };
  double low = 0.0, high = q * c;  // the frequency without joints is above
  for (int halving = 0; halving < 100; ++halving) {
    const double middle = 0.5 * (low + high);
    (excess(middle) > 0.0 ? low : high) = middle;
  }
  return low / q;
}

/// Half a spacing off the walls at both ends, so that the reflections of the box continue the set.
std::vector<JointPlane> planes() {
  std::vector<JointPlane> all;
  for (double x = 0.5 * kSpacing; x < kBox.x(); x += kSpacing)
    all.push_back({Vec3(x, 0.0, 0.0), Vec3::UnitX(), 1});
  return all;
}

RockSample cut_along(const std::vector<JointPlane>& joints) {
  std::vector<CutPlane> cuts;
  for (const JointPlane& joint : joints) cuts.push_back({joint.point, joint.normal});
  return uniform_rock(kBox, cuts);
}

void wave_speed(Report& report) {
  const std::vector<JointPlane> joints = planes();
  const RockSample sample = cut_along(joints);
  const JointMaterial material(rock(kRatio));
  const double density = rock(kRatio).density;
  for (const Polarisation kind : {Polarisation::p, Polarisation::s}) {
    const bool is_p = kind == Polarisation::p;
    const double modulus = is_p ? material.p_wave_modulus() : material.shear_modulus();
    for (const double compliance : {0.25, 1.0, 3.0}) {  // of the joints over the rock's
      const double stiffness = modulus / (compliance * kSpacing);
      JointClass joint;
      joint.tension = joint.cohesion = rock(kRatio).tension;
      joint.normal_stiffness = joint.shear_stiffness = stiffness;
      const double static_speed = std::sqrt(effective_modulus(modulus, stiffness) / density);
      const StandingWave wave = axial_wave(kind, 0, 1, kBox.x(), 1, static_speed);
      BlockRun run(sample.blocks, {rock(kRatio)}, walls_with(wave.parity, kBox), {{joint}, joints},
                   sample.leaning);
      const double speed = measured_frequency(run, wave, kPeriods, kStepShare) / wave.wave_number;
      const std::string name = std::string(is_p ? "P" : "S") + ", joints " + spelled(compliance) +
                               " times as compliant as the rock";
      report.relative({name, "speed across the joints", "m/s", "1/M + 1/(k s)"}, speed,
                      static_speed, kTolerance);
      report.relative(
          {name, "speed across the joints, their dispersion counted", "m/s", "Bloch waves"}, speed,
          exact_speed(modulus, density, stiffness, wave.wave_number), kTolerance);
    }
  }
}

const Cases kCases = {{"wave_speed", wave_speed}};

}  // namespace
}  // namespace muckpile::verification

int main(int argc, char** argv) {
  return muckpile::verification::run_case("joint_sets", muckpile::verification::kCases, argc, argv);
}
