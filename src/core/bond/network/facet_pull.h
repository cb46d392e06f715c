// SPDX-License-Identifier: GPL-2.0-or-later
// Tractions at the points of one facet in a step.
// Scope: data of a pass, one point per lane (facet_points.h); tractions are those on block i, block
// j gets the opposite at the same places, midway between the two sides. SI units.
#pragma once

#include "bond/network/facet_kinematics.h"

namespace muckpile {

struct FacetPull {
  LaneVec normal, jump, arm;  ///< arm: from the centre of block i [m]
  LaneVec rate;               ///< motion of block j's side against block i's [m/s]
  LaneVec traction;           ///< [Pa]

  explicit FacetPull(const FacetMotion& motion)
      : normal(motion.normal), jump(motion.jump()), arm(motion.side() + Lanes(0.5) * jump) {}

  void add(int p, const Vec3& t) {
    const auto k = static_cast<std::size_t>(p);
    traction.x[k] += t.x();
    traction.y[k] += t.y();
    traction.z[k] += t.z();
  }
};

}  // namespace muckpile
