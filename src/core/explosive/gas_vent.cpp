// SPDX-License-Identifier: GPL-2.0-or-later
// Venting by flow; equations in the header.
#include "explosive/gas_vent.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "args/require.h"

namespace muckpile {

double choked_flux(double pressure, double density, double gamma) {
  return std::sqrt(gamma * pressure * density) *
         std::pow(2.0 / (gamma + 1.0), 0.5 * (gamma + 1.0) / (gamma - 1.0));
}

namespace {

constexpr double kGrainDensity = 2650.0;  // kg/m3, of crushed stone

}  // namespace

GasVent::GasVent(const Parameters& parameters) : p_(parameters) {
  require_positive("hole_diameter", "m", 2.0 * p_.hole_radius);
  require_positive("crushed-zone radius", "m", p_.zone_radius);
  require_positive("mass of the gas of the charge", "kg", p_.products_mass);
  if (!(p_.gamma > 1.0)) refuse_value("gas_gamma", "> 1 with venting flow", "", p_.gamma);
  require_not_negative("stemming_length", "m", p_.stemming_length);
  require_positive("stemming_density", "kg/m3", p_.stemming_density);
  require_not_negative("stemming_shear", "Pa", p_.stemming_shear);
  require_not_negative("stemming_grain", "m", p_.stemming_grain);
  if (p_.stemming_grain > 0.0 && !(p_.stemming_density < kGrainDensity)) {
    refuse_value("stemming_density",
                 "< 2650 with stemming_grain above 0, that of stone without pores", "kg/m3",
                 p_.stemming_density);
  }
  require_not_negative("collar_discharge", "", p_.collar_discharge);
  require_not_negative("crack_delay", "s", p_.crack_delay);
  require_not_negative("crack_discharge", "", p_.crack_discharge);
}

double GasVent::bore() const {
  return p_.share * std::numbers::pi * p_.hole_radius * p_.hole_radius;
}

double GasVent::open_area(const GasState& state, const Chamber& chamber) const {
  const double in_hole = p_.stemming_length - state.stemming_path;  // [m]
  double area = bore() * (in_hole > 0.0 ? leak_discharge(in_hole) : p_.collar_discharge);
  if (chamber.time >= p_.crack_delay) {
    area += p_.crack_discharge * std::max(0.0, chamber.swept_volume) / p_.zone_radius;
  }
  return area;
}

/// Flow through the pores over the choked one through the open bore. Gas that expands in the pores
/// at one temperature has p dp = -c G^2 (p0/rho0) dx, c = 1.75 (1 - e)/(e^3 d), and leaves at next
/// to no pressure.
double GasVent::leak_discharge(double in_hole) const {
  if (p_.stemming_grain == 0.0) return 0.0;
  const double pores = 1.0 - p_.stemming_density / kGrainDensity;
  const double loss = 1.75 * (1.0 - pores) / (pores * pores * pores * p_.stemming_grain);  // [1/m]
  return std::min(p_.collar_discharge,
                  1.0 / (std::sqrt(2.0 * loss * in_hole) * choked_flux(1.0, 1.0, p_.gamma)));
}

double GasVent::cleared_room(const GasState& state) const {
  return bore() * std::min(state.stemming_path, p_.stemming_length);
}

void GasVent::advance(GasState& state, const Chamber& chamber, double dt) const {
  if (chamber.time < 0.0) return;
  const double flow =
      open_area(state, chamber) * choked_flux(chamber.pressure, chamber.gas_density, p_.gamma);
  // Over a step the flow falls in proportion to the mass: never below zero, exact for a steady
  // rate.
  state.mass_left *= std::exp(-flow * dt / (state.mass_left * p_.products_mass));
  if (state.stemming_out >= 0.0) return;
  if (state.stemming_path < p_.stemming_length) push_stemming(state, chamber, dt);
  if (state.stemming_path >= p_.stemming_length) state.stemming_out = chamber.time + dt;
}

void GasVent::push_stemming(GasState& state, const Chamber& chamber, double dt) const {
  const double in_hole = p_.stemming_length - state.stemming_path;
  const double drive = chamber.pressure - 2.0 * p_.stemming_shear * in_hole / p_.hole_radius;
  state.stemming_speed =
      std::max(0.0, state.stemming_speed + drive / (p_.stemming_density * p_.stemming_length) * dt);
  state.stemming_path += state.stemming_speed * dt;
}

}  // namespace muckpile
