// SPDX-License-Identifier: GPL-2.0-or-later
// Joints of any law in series with the rock.
// Scope: see the header.
#include "bond/law/joint_in_rock.h"

namespace muckpile {

SeriesPoints::Parts SeriesPoints::parts(const Lanes& along) const {
  const JointClosure<Lanes> joint = law->close(-along, uniaxial, history.closure);
  return {joint, along + joint.closure, 1.0 - joint.rate};
}

LaneVec SeriesPoints::traction(const LaneVec& normal, const LaneVec& jump,
                               const LaneVec& bulk) const {
  const Lanes along = dot(normal, jump);
  const Parts p = parts(along);
  const Lanes pull = rock * p.rock * p.rock_rate - p.joint.pressure * p.joint.rate;
  const LaneVec own = pull * normal + Lanes(shear) * (jump - along * normal);
  return own + (bulk + (p.rock_rate / rock_share - 1.0) * dot(normal, bulk) * normal);
}

LaneVec SeriesPoints::strained(const LaneVec& normal, const LaneVec& jump) const {
  const Lanes along = dot(normal, jump);
  return jump + (parts(along).rock / rock_share - along) * normal;
}

Lanes SeriesPoints::twice_energy(const LaneVec& normal, const LaneVec& jump) const {
  const Lanes along = dot(normal, jump);
  const Parts p = parts(along);
  return shear * (dot(jump, jump) - along * along) + rock * p.rock * p.rock +
         2.0 * law->stored(p.joint.closure, max(history.closure, p.joint.closure));
}

/// With U = (lambda + 2G)/h, a = (2G/h)/U and x U the joint's stiffness the point has
///     U x (a x + 1)/(1 + x)^2,
/// which grows towards a U as the joint closes, and has a maximum before that where a < 1/2.
StiffestNormal SeriesPoints::stiffest() const {
  const double a = rock / uniaxial;
  return {a < 0.5 ? uniaxial / (4.0 * (1.0 - a)) : rock, 1.0 / rock_share};
}

Lanes SeriesContact::traction(const Lanes& gap) const {
  return -fade * law->close(-gap, uniaxial, largest).pressure;
}

Lanes SeriesContact::closure(const Lanes& gap) const {
  const JointClosure<Lanes> joint = law->close(-gap, uniaxial, largest);
  return choose(joint.pressure > 0.0, joint.closure, -gap);
}

Lanes SeriesContact::twice_energy(const Lanes& gap) const {
  const JointClosure<Lanes> joint = law->close(-gap, uniaxial, largest);
  const Lanes rock = -gap - joint.closure;
  const Lanes whole =
      uniaxial * rock * rock + 2.0 * law->stored(joint.closure, max(largest, joint.closure));
  return choose(joint.pressure > 0.0, fade * whole, 0.0);
}

Lanes SeriesContact::stiffness_to(const Lanes& tension) const {
  return choose(tension > 0.0, tension / (gap(tension) - gap(0.0)), uniaxial);
}

Lanes SeriesContact::gap(const Lanes& traction) const {
  return -law->jump_at(-traction, uniaxial, largest);
}

}  // namespace muckpile
