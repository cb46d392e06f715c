// SPDX-License-Identifier: GPL-2.0-or-later
// Elastic waves around a pressurised cavity in an endless medium, sphere and cylinder.
// Scope: verification of the blast load and of the block network; linear, isotropic, undamped.
#pragma once

#include <complex>
#include <functional>

namespace muckpile {

struct ElasticMedium {
  double density;  ///< [kg/m3]
  double p_speed;  ///< longitudinal wave speed [m/s]
  double s_speed;  ///< shear wave speed [m/s]
};

/// Density and speeds from Young's modulus [Pa] and Poisson's ratio.
[[nodiscard]] ElasticMedium elastic_medium(double density, double youngs_modulus,
                                           double poisson_ratio);

struct CavityResponse {
  double displacement;   ///< radial, outward [m]
  double velocity;       ///< radial, outward [m/s]
  double radial_stress;  ///< tension positive [Pa]
  double hoop_stress;    ///< tension positive [Pa]
};

/// Laplace transform of the pressure in the cavity, p(s) [Pa s].
using PressureTransform = std::function<std::complex<double>(std::complex<double>)>;
/// Constant pressure from time 0 on: p0 / s.
[[nodiscard]] PressureTransform step_pressure(double pressure);
/// Starfield-Pugliese pulse (explosive/starfield_pulse.h) of a peak [Pa] and rise time [s].
[[nodiscard]] PressureTransform starfield_pressure(double peak, double rise_time);

enum class CavityShape { sphere, cylinder };

/// Response at distance r >= a from the centre (axis) of a cavity of radius a, `time` seconds after
/// the pressure began; all zero up to the arrival (r - a)/p_speed. Sphere: Blake (1952), Sharpe
/// (1942); cylinder in plane strain: Selberg (1952); both re-derived from the radial equation of
/// motion, inverted numerically with time counted from the arrival. InputError if a <= 0 or r < a.
[[nodiscard]] CavityResponse cavity_response(CavityShape shape, const ElasticMedium& medium,
                                             double cavity_radius,
                                             const PressureTransform& pressure, double r,
                                             double time);

/// The sphere under a step, in closed form: displacement [m] (Blake 1952, potential psi of decay
/// 2 cs^2/(a cp) and frequency (2 cs/a) sqrt(1 - cs^2/cp^2)).
[[nodiscard]] double sphere_step_displacement(const ElasticMedium& medium, double cavity_radius,
                                              double pressure, double r, double time);

}  // namespace muckpile
