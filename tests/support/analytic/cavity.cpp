// SPDX-License-Identifier: GPL-2.0-or-later
// Cavity under internal pressure: transforms of displacement and stress, and their inversion.
#include "analytic/cavity.h"

#include <cmath>
#include <numbers>
#include <sstream>

#include "analytic/bessel_k.h"
#include "analytic/laplace_inversion.h"
#include "args/input_error.h"

namespace muckpile {
namespace {

using Complex = std::complex<double>;

/// Displacement u and gradient du/dr of an outgoing wave, both times exp(k (r - a)); any amplitude.
struct Mode {
  Complex u, gradient;
};

/// Sphere: u = d/dr (exp(-kr)/r).
Mode sphere_mode(Complex k, double r) {
  return {-(k * r + 1.0) / (r * r), (k * k * r * r + 2.0 * k * r + 2.0) / (r * r * r)};
}

/// Cylinder: u = K1(kr), du/dr = -k K0(kr) - K1(kr)/r; scaled by exp(kr), a common factor.
Mode cylinder_mode(Complex k, double r) {
  const ScaledBesselK bessel = scaled_bessel_k(k * r);
  return {bessel.k1, -k * bessel.k0 - bessel.k1 / r};
}

struct Stresses {
  Complex radial, hoop;
};

Stresses stresses(CavityShape shape, const ElasticMedium& medium, const Mode& mode, double r) {
  const double shear_modulus = medium.density * medium.s_speed * medium.s_speed;
  const double lambda = medium.density * medium.p_speed * medium.p_speed - 2.0 * shear_modulus;
  const Complex hoop_strain = mode.u / r;
  const double hoops = shape == CavityShape::sphere ? 2.0 : 1.0;
  const Complex dilatation = mode.gradient + hoops * hoop_strain;
  return {lambda * dilatation + 2.0 * shear_modulus * mode.gradient,
          lambda * dilatation + 2.0 * shear_modulus * hoop_strain};
}

void check_radii(double cavity_radius, double r) {
  if (cavity_radius > 0.0 && r >= cavity_radius) return;
  std::ostringstream text;
  text << "cavity: need 0 < radius <= r [m], got radius '" << cavity_radius << "', r '" << r << "'";
  throw InputError(text.str());
}

}  // namespace

ElasticMedium elastic_medium(double density, double youngs_modulus, double poisson_ratio) {
  const double shear_modulus = youngs_modulus / (2.0 * (1.0 + poisson_ratio));
  const double p_modulus =
      2.0 * shear_modulus * (1.0 - poisson_ratio) / (1.0 - 2.0 * poisson_ratio);
  return {density, std::sqrt(p_modulus / density), std::sqrt(shear_modulus / density)};
}

PressureTransform step_pressure(double pressure) {
  return [pressure](Complex s) { return pressure / s; };
}

PressureTransform starfield_pressure(double peak, double rise_time) {
  const double rate = std::numbers::ln2 / rise_time;  // x = exp(-rate t)
  return
      [peak, rate](Complex s) { return 4.0 * peak * (1.0 / (s + rate) - 1.0 / (s + 2.0 * rate)); };
}

CavityResponse cavity_response(CavityShape shape, const ElasticMedium& medium, double cavity_radius,
                               const PressureTransform& pressure, double r, double time) {
  check_radii(cavity_radius, r);
  const double since_arrival = time - (r - cavity_radius) / medium.p_speed;
  if (since_arrival <= 0.0) return {0.0, 0.0, 0.0, 0.0};
  const auto mode_at = shape == CavityShape::sphere ? sphere_mode : cylinder_mode;
  CavityResponse response{0.0, 0.0, 0.0, 0.0};
  for (const TalbotNode& node : talbot_nodes(since_arrival)) {
    if (node.weight == 0.0) continue;
    const Complex k = node.s / medium.p_speed;
    const Stresses wall = stresses(shape, medium, mode_at(k, cavity_radius), cavity_radius);
    const Mode mode = mode_at(k, r);
    const Stresses here = stresses(shape, medium, mode, r);
    const Complex amplitude = -node.weight * pressure(node.s) / wall.radial;
    response.displacement += (amplitude * mode.u).real();
    response.velocity += (amplitude * node.s * mode.u).real();
    response.radial_stress += (amplitude * here.radial).real();
    response.hoop_stress += (amplitude * here.hoop).real();
  }
  return response;
}

double sphere_step_displacement(const ElasticMedium& medium, double cavity_radius, double pressure,
                                double r, double time) {
  check_radii(cavity_radius, r);
  const double a = cavity_radius;
  const double tau = time - (r - a) / medium.p_speed;
  if (tau <= 0.0) return 0.0;
  const double ratio2 = std::pow(medium.s_speed / medium.p_speed, 2);
  const double sigma = 2.0 * medium.s_speed * medium.s_speed / (a * medium.p_speed);
  const double omega = 2.0 * medium.s_speed / a * std::sqrt(1.0 - ratio2);
  const double scale = -pressure * a * a * a / (4.0 * medium.density * std::pow(medium.s_speed, 2));
  const double decay = std::exp(-sigma * tau);
  const double psi =
      scale * (1.0 - decay * (std::cos(omega * tau) + sigma / omega * std::sin(omega * tau)));
  const double psi_rate =
      scale * decay * (sigma * sigma + omega * omega) / omega * std::sin(omega * tau);
  return -psi_rate / (r * medium.p_speed) - psi / (r * r);
}

}  // namespace muckpile
