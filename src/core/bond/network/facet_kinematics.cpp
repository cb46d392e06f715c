// SPDX-License-Identifier: GPL-2.0-or-later
// How the two sides of a facet lie in the present pose: jumps of points that have slipped.
// Scope: see the header.
#include "bond/network/facet_kinematics.h"

#include "bond/network/joint_points.h"

namespace muckpile {

LaneVec FacetKinematics::elastic_jump(std::size_t f, const FacetMotion& motion) const {
  const FacetTraces& traces = history.traces(f);
  if (!traces.slipping.any()) return motion.jump();
  const LaneVec slipped = rotated(motion.axes(), lanes_of(history.contacts().get(f).offset));
  return motion.jump() - choose(where_slipping(traces), Lanes(1.0), 0.0) * slipped;
}

Vec3 FacetKinematics::bonded_jump_of_points(std::size_t f, FacetMotion motion) const {
  const LaneMask holds = is_point() && !where_contact(history.traces(f));
  const LaneVec strained = of_bonded(*this, f, [&](const auto& points) {
    return points.strained(LaneVec(motion.normal), elastic_jump(f, motion));
  });
  return sum(choose(holds, Lanes(1.0 / kFacetPoints), 0.0) * strained);
}

}  // namespace muckpile
