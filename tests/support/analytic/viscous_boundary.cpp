// SPDX-License-Identifier: GPL-2.0-or-later
// Plane wave on a viscous boundary: two equations for the two reflected amplitudes.
// Scope: see the header.
#include "analytic/viscous_boundary.h"

#include <array>
#include <cmath>
#include <complex>

namespace muckpile {
namespace {

using Complex = std::complex<double>;
using Pair = std::array<Complex, 2>;  // along the boundary, and away from it into the rock

/// Displacement p exp(i w (t - d.x/c)). The rock is z > 0; a decaying wave has a complex d.
struct PlaneWave {
  Pair direction, polarisation;
  double speed;
};

/// Traction on the rock at z = 0 plus what the dashpots hold against it, over i w and density:
/// zero for the sum of all waves. cS is the unit of speed, so G/rho = 1, lambda/rho = cP^2 - 2.
Pair imbalance(const PlaneWave& wave, double p_speed) {
  const Pair& p = wave.polarisation;
  const Pair& d = wave.direction;
  const Complex dilatation = p[0] * d[0] + p[1] * d[1];
  // Outward normal (0, -1): stress -(1/c) [lambda p.d 1 + G (p d' + d p')] times that.
  const Complex along = (p[0] * d[1] + p[1] * d[0]) / wave.speed;
  const Complex across = ((p_speed * p_speed - 2.0) * dilatation + 2.0 * p[1] * d[1]) / wave.speed;
  return {along + p[0], across + p_speed * p[1]};
}

}  // namespace

double viscous_boundary_reflection(WaveType incident, double angle, double poisson_ratio) {
  const double p_speed = std::sqrt((2.0 - 2.0 * poisson_ratio) / (1.0 - 2.0 * poisson_ratio));
  const double speed = incident == WaveType::p ? p_speed : 1.0;
  const double slowness = std::sin(angle) / speed;  // along the boundary, the same for all waves
  const double sin_p = slowness * p_speed, sin_s = slowness;
  // Beyond the critical angle the reflected P-wave decays from the boundary and carries nothing.
  const Complex cos_p = sin_p <= 1.0 ? Complex(std::sqrt(1.0 - sin_p * sin_p))
                                     : Complex(0.0, -std::sqrt(sin_p * sin_p - 1.0));
  const double cos_s = std::sqrt(1.0 - sin_s * sin_s);
  const PlaneWave back_p{{sin_p, cos_p}, {sin_p, cos_p}, p_speed};
  const PlaneWave back_s{{sin_s, cos_s}, {cos_s, -sin_s}, 1.0};
  const double c = std::cos(angle), s = std::sin(angle);
  const PlaneWave in{{s, -c}, incident == WaveType::p ? Pair{s, -c} : Pair{c, s}, speed};
  // amplitude_p u + amplitude_s v = -w, by Cramer's rule
  const Pair u = imbalance(back_p, p_speed), v = imbalance(back_s, p_speed),
             w = imbalance(in, p_speed);
  const Complex all = u[0] * v[1] - u[1] * v[0];
  const Complex of_p = (v[0] * w[1] - v[1] * w[0]) / all, of_s = (u[1] * w[0] - u[0] * w[1]) / all;
  return (std::norm(of_p) * p_speed * cos_p.real() + std::norm(of_s) * cos_s) / (speed * c);
}

}  // namespace muckpile
