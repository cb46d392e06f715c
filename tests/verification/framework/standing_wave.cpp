// SPDX-License-Identifier: GPL-2.0-or-later
// Standing waves in a box of blocks that its reflections continue: their measured frequency.
// Scope: see the header.
#include "framework/standing_wave.h"

#include <cmath>
#include <numbers>
#include <vector>

#include "framework/frequency_fit.h"

namespace muckpile::verification {
namespace {

constexpr double kStrain = 1e-6;  // amplitude x wave number: far from any second-order effect

}  // namespace

StandingWave axial_wave(Polarisation kind, int a, int b, double edge, int half_waves,
                        double speed) {
  const double k = half_waves * std::numbers::pi / edge;
  StandingWave wave;
  wave.wave_number = k;
  wave.speed = speed;
  wave.parity = Vec3::Ones();
  wave.name = std::string(kind == Polarisation::p ? "P " : "S ") + "xyz"[a];
  if (kind == Polarisation::p) {
    wave.displacement = [=](const Vec3& x) -> Vec3 { return std::sin(k * x[a]) * Vec3::Unit(a); };
    wave.curl = [](const Vec3&) -> Vec3 { return Vec3::Zero(); };
  } else {
    wave.parity[b] = -1.0;
    wave.displacement = [=](const Vec3& x) -> Vec3 { return std::cos(k * x[a]) * Vec3::Unit(b); };
    wave.curl = [=](const Vec3& x) -> Vec3 {
      return -k * std::sin(k * x[a]) * Vec3::Unit(a).cross(Vec3::Unit(b));
    };
  }
  return wave;
}

StandingWave diagonal_wave(Polarisation kind, bool in_plane, double edge, int half_waves,
                           double speed) {
  const double q = half_waves * std::numbers::pi / edge;
  StandingWave wave;
  wave.wave_number = std::sqrt(2.0) * q;
  wave.speed = speed;
  wave.parity = Vec3::Ones();
  wave.name = kind == Polarisation::p ? "P xy" : in_plane ? "S xy in plane" : "S xy along z";
  if (kind == Polarisation::s && !in_plane) {
    wave.parity[2] = -1.0;
    wave.displacement = [=](const Vec3& x) {
      return Vec3(0.0, 0.0, std::cos(q * x.x()) * std::cos(q * x.y()));
    };
    wave.curl = [=](const Vec3& x) {
      return Vec3(-q * std::cos(q * x.x()) * std::sin(q * x.y()),
                  q * std::sin(q * x.x()) * std::cos(q * x.y()), 0.0);
    };
    return wave;
  }
  const double sign = kind == Polarisation::p ? 1.0 : -1.0;
  wave.displacement = [=](const Vec3& x) {
    return Vec3(std::sin(q * x.x()) * std::cos(q * x.y()),
                sign * std::cos(q * x.x()) * std::sin(q * x.y()), 0.0);
  };
  wave.curl = [=](const Vec3& x) {
    return Vec3(0.0, 0.0, q * (1.0 - sign) * std::sin(q * x.x()) * std::sin(q * x.y()));
  };
  return wave;
}

double measured_frequency(BlockRun& run, const StandingWave& wave, double periods,
                          double step_share) {
  const double amplitude = kStrain / wave.wave_number, guess = wave.wave_number * wave.speed;
  double shape = 0.0;
  for (std::size_t b = 0; b < run.size(); ++b) {
    const Vec3 u = wave.displacement(run.start(b));
    run.place(b, amplitude * u, 0.5 * amplitude * wave.curl(run.start(b)));
    run.set_motion(b, Vec3::Zero(), Vec3::Zero());
    shape += run.mass(b) * u.squaredNorm();
  }
  run.compute();
  const double dt = step_share * run.stable_step();
  const auto steps = static_cast<int>(std::ceil(periods * 2.0 * std::numbers::pi / guess / dt));
  std::vector<Sample> samples;
  for (int n = 0; n <= steps; ++n) {
    if (n > 0) run.step(dt);
    double part = 0.0;
    for (std::size_t b = 0; b < run.size(); ++b) {
      part += run.mass(b) * run.displacement(b).dot(wave.displacement(run.start(b)));
    }
    samples.push_back({n * dt, part / (shape * amplitude)});
  }
  return fitted_frequency(samples, 0.6 * guess, 1.3 * guess);
}

}  // namespace muckpile::verification
