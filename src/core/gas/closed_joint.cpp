// SPDX-License-Identifier: GPL-2.0-or-later
// How wide a broken joint is for gas; equations in the header.
#include "gas/closed_joint.h"

#include <limits>

#include "args/require.h"

namespace muckpile {

ClosedJoint::ClosedJoint(const Parameters& parameters)
    : p_(parameters),
      limit_(p_.closure_share * p_.residual_aperture),
      half_stress_(std::max(p_.closure_stiffness * limit_, std::numeric_limits<double>::min())),
      smooth_from_(smooth_from_aperture(p_.roughness)) {
  require_positive("residual_aperture", "m", p_.residual_aperture);
  if (!(p_.closure_share >= 0.0 && p_.closure_share < 1.0))
    refuse_value("closure_share", ">= 0 and < 1", "", p_.closure_share);
  if (p_.closure_share > 0.0) require_positive("closure_stiffness", "Pa/m", p_.closure_stiffness);
  require_not_negative("roughness_coefficient", "", p_.roughness);
}

}  // namespace muckpile
