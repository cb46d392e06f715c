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

double CrackFlow::flux(const GasPoint& upstream, double downstream_pressure, double aperture,
                       double length) const {
  const double ratio = downstream_pressure / upstream.pressure;
  if (!(ratio < 1.0)) return 0.0;
  const double expanded = ratio > 0.0 ? ratio * std::pow(ratio, 1.0 / p_.gamma) : 0.0;
  const double resistance = 1.0 + friction_factor(aperture) * length / (2.0 * aperture);
  const double share = 2.0 * p_.gamma / (p_.gamma + 1.0) * (1.0 - expanded) / resistance;
  return std::sqrt(upstream.pressure * upstream.density) * std::min(std::sqrt(share), choked_);
}

}  // namespace muckpile
