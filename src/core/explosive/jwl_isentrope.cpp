// SPDX-License-Identifier: GPL-2.0-or-later
// JWL isentrope; equations in the header.
#include "explosive/jwl_isentrope.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "args/require.h"
#include "explosive/volume_ratio.h"

namespace muckpile {
namespace {

double checked_cj_volume(const JwlParameters& p) {
  require_positive("jwl A", "Pa", p.a);
  require_not_negative("jwl B", "Pa", p.b);
  require_positive("jwl R1", "", p.r1);
  require_not_negative("jwl R2", "", p.r2);
  require_positive("jwl omega", "", p.omega);
  require_positive("jwl Chapman-Jouguet pressure", "Pa", p.cj_pressure);
  require_positive("jwl density", "kg/m3", p.density);
  require_positive("jwl vod", "m/s", p.detonation_velocity);
  const double inertia = p.density * p.detonation_velocity * p.detonation_velocity;
  if (p.cj_pressure >= inertia) {
    refuse_value("jwl Chapman-Jouguet pressure", "below density x vod^2", "Pa", p.cj_pressure);
  }
  return 1.0 - p.cj_pressure / inertia;
}

}  // namespace

JwlIsentrope::JwlIsentrope(const JwlParameters& parameters)
    : p_(parameters), cj_volume_(checked_cj_volume(parameters)), gas_(0.0) {
  const double rest = p_.cj_pressure - curve(cj_volume_);
  if (rest <= 0.0) {
    refuse_value("jwl Chapman-Jouguet pressure", "above the A and B terms there", "Pa",
                 p_.cj_pressure);
  }
  gas_ = rest * std::pow(cj_volume_, 1.0 + p_.omega);
}

double JwlIsentrope::curve(double volume) const {
  return p_.a * std::exp(-p_.r1 * volume) + p_.b * std::exp(-p_.r2 * volume) +
         gas_ * std::pow(volume, -1.0 - p_.omega);
}

double JwlIsentrope::pressure(double volume_ratio) const {
  return curve(std::max(volume_ratio, 1.0));
}

double JwlIsentrope::volume_ratio_at(double wanted) const {
  return volume_ratio_where(1.0, [&](double ratio) { return curve(ratio) > wanted; });
}

double JwlIsentrope::energy_from(double v) const {
  return p_.a / p_.r1 * std::exp(-p_.r1 * v) +
         (p_.r2 > 0.0 ? p_.b / p_.r2 * std::exp(-p_.r2 * v) : 0.0) +
         gas_ / p_.omega * std::pow(v, -p_.omega);
}

double JwlIsentrope::stored_energy(double volume_ratio) const {
  return curve(1.0) * std::max(0.0, 1.0 - volume_ratio) + energy_from(std::max(volume_ratio, 1.0));
}

double JwlIsentrope::implied_energy() const {
  return energy_from(cj_volume_) - 0.5 * p_.cj_pressure * (1.0 - cj_volume_);
}

JwlGas::JwlGas(const JwlParameters& parameters, double switch_pressure)
    : isentrope_(parameters), switch_ratio_(isentrope_.volume_ratio_at(switch_pressure)) {
  if (switch_ratio_ <= JwlIsentrope::kFittedTo) return;
  std::ostringstream rule;
  rule << "at least " << isentrope_.pressure(JwlIsentrope::kFittedTo) << " Pa, the pressure at "
       << JwlIsentrope::kFittedTo << " V0 to which JWL is fitted";
  refuse_value("gas_switch_pressure", rule.str().c_str(), "", switch_pressure);
}

}  // namespace muckpile
