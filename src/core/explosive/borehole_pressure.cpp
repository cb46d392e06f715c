// SPDX-License-Identifier: GPL-2.0-or-later
// Borehole pressure formulas; see the header for their sources.
#include "explosive/borehole_pressure.h"

#include <cmath>

#include "args/require.h"

namespace muckpile {
namespace {

double rho_d_squared(const Explosive& explosive) {
  require_positive("explosive_density", "kg/m3", explosive.density);
  require_positive("vod", "m/s", explosive.detonation_velocity);
  return explosive.density * explosive.detonation_velocity * explosive.detonation_velocity;
}

}  // namespace

double chapman_jouguet_pressure(const Explosive& explosive, double gamma) {
  require_positive("gamma", "", gamma);
  return rho_d_squared(explosive) / (1.0 + gamma);
}

double explosion_state_pressure(const Explosive& explosive) {
  return rho_d_squared(explosive) / 8.0;
}

double explosion_state_pressure_by_gamma(const Explosive& explosive, double gamma) {
  return chapman_jouguet_pressure(explosive, gamma) * std::pow(gamma / (1.0 + gamma), gamma);
}

double explosion_state_pressure_fit(const Explosive& explosive) {
  // rho^0.868 D^2 = rho D^2 rho^-0.132 with rho in g/cm3; 1 g/cm3 (km/s)^2 = 1 GPa.
  constexpr double kWaterDensity = 1000.0;  // [kg/m3]
  return 0.115 * rho_d_squared(explosive) * std::pow(explosive.density / kWaterDensity, -0.132);
}

double impedance_matched_pressure(const Explosive& explosive, double rock_impedance) {
  require_positive("rock impedance", "Pa s/m", rock_impedance);
  const double impedance = explosive.density * explosive.detonation_velocity;
  return rho_d_squared(explosive) / 4.0 * 2.0 / (1.0 + impedance / rock_impedance);
}

}  // namespace muckpile
