// SPDX-License-Identifier: GPL-2.0-or-later
// Isentrope of a gas with covolume; equations in the header.
#include "explosive/covolume_isentrope.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "args/require.h"

namespace muckpile {

CovolumeIsentrope::CovolumeIsentrope(const Parameters& parameters)
    : initial_pressure_(parameters.initial_pressure), gamma_(parameters.gamma) {
  require_positive("borehole_pressure", "Pa", initial_pressure_);
  require_positive("explosive_energy x explosive_density", "J/m3", parameters.energy);
  require_positive("gas_gamma less 1", "", gamma_ - 1.0);
  require_positive("gas_switch_pressure", "Pa", parameters.switch_pressure);
  covolume_ = 1.0 - (gamma_ - 1.0) * parameters.energy / initial_pressure_;
  if (covolume_ < 0.0) {
    std::ostringstream rule;
    rule << "at most " << initial_pressure_ / (gamma_ - 1.0)
         << ", what products of exponent gas_gamma hold at P0 = " << initial_pressure_
         << " Pa (a slow detonation releases less: energy_share),";
    refuse_value("explosive_energy x explosive_density", rule.str(), "J/m3", parameters.energy);
  }
  const double fall = std::min(1.0, parameters.switch_pressure / initial_pressure_);
  switch_ratio_ = covolume_ + (1.0 - covolume_) * std::pow(fall, -1.0 / gamma_);
}

double CovolumeIsentrope::pressure(double volume_ratio) const {
  const double room = std::max(volume_ratio, 1.0) - covolume_;
  return initial_pressure_ * std::pow((1.0 - covolume_) / room, gamma_);
}

double CovolumeIsentrope::stored_energy(double volume_ratio) const {
  const double ratio = std::max(volume_ratio, 1.0);
  const double plateau = initial_pressure_ * std::max(0.0, 1.0 - volume_ratio);
  return plateau + pressure(ratio) * (ratio - covolume_) / (gamma_ - 1.0);
}

}  // namespace muckpile
