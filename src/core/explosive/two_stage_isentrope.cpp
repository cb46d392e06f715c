// SPDX-License-Identifier: GPL-2.0-or-later
// Two-stage isentrope of detonation products; equations in the header.
#include "explosive/two_stage_isentrope.h"

#include <algorithm>
#include <cmath>

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

}  // namespace muckpile
