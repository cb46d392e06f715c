// SPDX-License-Identifier: GPL-2.0-or-later
// Flow along a rough crack; equations in the header.
#include "gas/crack_flow.h"

#include "args/require.h"
#include "explosive/gas_vent.h"

namespace muckpile {
namespace {
constexpr double kFullyRough = 0.143;  // f at an aperture of the roughness
}

CrackFlow::CrackFlow(const Parameters& parameters) : p_(parameters) {
  if (!(p_.gamma > 1.0)) refuse_value("gas_gamma", "> 1 in cracks", "", p_.gamma);
  require_not_negative("roughness", "m", p_.roughness);
  choked_ = choked_flux(1.0, 1.0, p_.gamma);
  drive_ = std::sqrt(2.0 * p_.gamma / (p_.gamma + 1.0));
  friction_ = kFullyRough * std::cbrt(p_.roughness);
}

double CrackFlow::friction_factor(double aperture) const { return friction_ / std::cbrt(aperture); }

}  // namespace muckpile
