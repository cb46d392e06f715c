// SPDX-License-Identifier: GPL-2.0-or-later
// Two-stage isentrope of detonation products; equations in the header.
#include "explosive/two_stage_isentrope.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "args/require.h"

namespace muckpile {

TwoStageIsentrope::TwoStageIsentrope(const Parameters& parameters)
    : initial_pressure_(parameters.initial_pressure),
      switch_pressure_(std::min(parameters.switch_pressure, parameters.initial_pressure)),
      dense_exponent_(parameters.dense_exponent),
      dilute_exponent_(parameters.dilute_exponent) {
  require_positive("borehole_pressure", "Pa", parameters.initial_pressure);
  require_positive("gas_switch_pressure", "Pa", parameters.switch_pressure);
  require_positive("gas_gamma_dense", "", parameters.dense_exponent);
  require_positive("gas_gamma", "", parameters.dilute_exponent);
  switch_ratio_ = std::pow(initial_pressure_ / switch_pressure_, 1.0 / dense_exponent_);
}

double TwoStageIsentrope::pressure(double volume_ratio) const {
  if (volume_ratio >= switch_ratio_) {
    return switch_pressure_ * std::pow(switch_ratio_ / volume_ratio, dilute_exponent_);
  }
  return initial_pressure_ * std::pow(std::max(volume_ratio, 1.0), -dense_exponent_);
}

double TwoStageIsentrope::stored_energy(double volume_ratio) const {
  // The energy of a gas of exponent g is p V/(g - 1); V in charge volumes.
  if (volume_ratio >= switch_ratio_) {
    return pressure(volume_ratio) * volume_ratio / (dilute_exponent_ - 1.0);
  }
  const double plateau = initial_pressure_ * std::max(0.0, 1.0 - volume_ratio);
  const double ratio = std::max(volume_ratio, 1.0);
  const double at_switch = switch_pressure_ * switch_ratio_;
  return plateau + (pressure(ratio) * ratio - at_switch) / (dense_exponent_ - 1.0) +
         at_switch / (dilute_exponent_ - 1.0);
}

double TwoStageIsentrope::work_down_to(double pressure) const {
  if (pressure >= initial_pressure_) return 0.0;
  if (pressure <= 0.0) return stored_energy(1.0);
  const double ratio =
      pressure > switch_pressure_
          ? std::pow(initial_pressure_ / pressure, 1.0 / dense_exponent_)
          : switch_ratio_ * std::pow(switch_pressure_ / pressure, 1.0 / dilute_exponent_);
  return stored_energy(1.0) - stored_energy(ratio);
}

double energy_switch_pressure(const TwoStageIsentrope::Parameters& parameters, double energy) {
  const double p0 = parameters.initial_pressure;
  const double dense = parameters.dense_exponent - 1.0, dilute = parameters.dilute_exponent - 1.0;
  require_positive("gas_gamma_dense less 1", "", dense);
  require_positive("gas_gamma less 1", "", dilute);
  if (dilute >= dense) {
    refuse_value("gas_gamma", "below gas_gamma_dense with gas_switch_pressure energy", "",
                 parameters.dilute_exponent);
  }
  const double y = (energy / p0 - 1.0 / dense) / (1.0 / dilute - 1.0 / dense);
  if (y > 0.0 && y <= 1.0) return p0 * std::pow(y, parameters.dense_exponent / dense);
  std::ostringstream rule;
  rule << "above " << p0 / dense << " and at most " << p0 / dilute
       << ", what products of these exponents can hold at P0 = " << p0
       << " Pa (a slow detonation releases less: energy_share),";
  refuse_value("explosive_energy x explosive_density", rule.str(), "J/m3", energy);
}

}  // namespace muckpile
