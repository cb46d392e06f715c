// SPDX-License-Identifier: GPL-2.0-or-later
// Flow along a rough crack; equations in the header.
#include "gas/crack_flow.h"

#include <algorithm>
#include <cmath>

#include "explosive/gas_vent.h"
#include "explosive/require.h"

namespace muckpile {

CrackFlow::CrackFlow(const Parameters& parameters) : p_(parameters) {
  if (!(p_.gamma > 1.0)) explosive_detail::refuse("gas_gamma", "> 1 in cracks", "", p_.gamma);
  explosive_detail::require_not_negative("roughness", "m", p_.roughness);
  choked_ = choked_flux(1.0, 1.0, p_.gamma);
}

double CrackFlow::friction_factor(double aperture) const {
  return 0.143 * std::cbrt(p_.roughness / aperture);
}

CrackFlow::Fall CrackFlow::fall(double upstream_pressure, double downstream_pressure) const {
  const double ratio = downstream_pressure / upstream_pressure;
  return {ratio, ratio > 0.0 ? std::pow(ratio, 1.0 / p_.gamma) : 0.0};
}

double CrackFlow::passage(double aperture, double length) const {
  return 1.0 / std::sqrt(1.0 + friction_factor(aperture) * length / (2.0 * aperture));
}

double CrackFlow::flux(const GasPoint& upstream, const Fall& fall, double passage) const {
  if (!(fall.ratio < 1.0)) return 0.0;
  const double share = 2.0 * p_.gamma / (p_.gamma + 1.0) * (1.0 - fall.ratio * fall.thinning);
  return std::sqrt(upstream.pressure * upstream.density) *
         std::min(std::sqrt(share) * passage, choked_);
}

}  // namespace muckpile
