// SPDX-License-Identifier: GPL-2.0-or-later
// How the two sides of a facet lie in the present pose: jumps of points that have slipped.
// Scope: see the header.
#include "bond/network/facet_kinematics.h"

namespace muckpile {

LaneVec FacetKinematics::elastic_jump(std::size_t f, const FacetMotion& motion) const {
  const FacetTraces& traces = history.traces(f);
  if (!traces.slipping.any()) return motion.jump();
  const LaneVec slipped = rotated(motion.axes(), lanes_of(history.contacts().get(f).offset));
  return motion.jump() - choose(where_slipping(traces), Lanes(1.0), 0.0) * slipped;
}

Vec3 FacetKinematics::bonded_jump_of_points(std::size_t f, FacetMotion motion) const {
  if (tables.nonlinear_law(f) != nullptr) return nonlinear_bonded_jump(*this, f, motion);
  const LaneMask holds = is_point() && !where_contact(history.traces(f));
  return sum(choose(holds, Lanes(1.0 / kFacetPoints), 0.0) * elastic_jump(f, motion));
}

}  // namespace muckpile
