// SPDX-License-Identifier: GPL-2.0-or-later
// Joints of a law of their own in series with the rock.
// Scope: see the header.
#include "bond/law/joint_law.h"

namespace muckpile {

OwnClosure::Parts OwnClosure::parts(const Lanes& along) const {
  const JointClosure<Lanes> joint = law->close(-along, uniaxial, history.closure);
  return {joint, along + joint.closure, 1.0 - joint.rate};
}

LaneVec OwnClosure::traction(const LaneVec& normal, const LaneVec& jump) const {
  const Lanes along = dot(normal, jump);
  const Parts p = parts(along);
  const Lanes pull = rock * p.rock * p.rock_rate - p.joint.pressure * p.joint.rate;
  return pull * normal + Lanes(shear) * (jump - along * normal);
}

LaneVec OwnClosure::passed_on(const LaneVec& normal, const LaneVec& jump,
                              const LaneVec& traction) const {
  const Parts p = parts(dot(normal, jump));
  const Lanes along = dot(normal, traction);
  return traction + (p.rock_rate / rock_share - 1.0) * along * normal;
}

LaneVec OwnClosure::strained(const LaneVec& normal, const LaneVec& jump) const {
  const Lanes along = dot(normal, jump);
  return jump + (parts(along).rock / rock_share - along) * normal;
}

Lanes OwnClosure::twice_energy(const LaneVec& normal, const LaneVec& jump) const {
  const Lanes along = dot(normal, jump);
  const Parts p = parts(along);
  return shear * (dot(jump, jump) - along * along) + rock * p.rock * p.rock +
         2.0 * law->stored(p.joint.closure, max(history.closure, p.joint.closure));
}

Lanes OwnClosure::tangent(const Lanes& along) const {
  const Parts p = parts(along);
  return rock * p.rock_rate * p.rock_rate + p.joint.tangent * p.joint.rate * p.joint.rate;
}

Lanes OwnContact::traction(const Lanes& gap) const {
  return -fade * law->close(-gap, uniaxial, largest).pressure;
}

Lanes OwnContact::closure(const Lanes& gap) const {
  const JointClosure<Lanes> joint = law->close(-gap, uniaxial, largest);
  return choose(joint.pressure > 0.0, joint.closure, -gap);
}

Lanes OwnContact::twice_energy(const Lanes& gap) const {
  const JointClosure<Lanes> joint = law->close(-gap, uniaxial, largest);
  const Lanes rock = -gap - joint.closure;
  const Lanes whole =
      uniaxial * rock * rock + 2.0 * law->stored(joint.closure, max(largest, joint.closure));
  return choose(joint.pressure > 0.0, fade * whole, 0.0);
}

Lanes OwnContact::gap(const Lanes& traction) const {
  return -law->jump_at(-traction, uniaxial, largest);
}

}  // namespace muckpile
