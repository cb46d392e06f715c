// SPDX-License-Identifier: GPL-2.0-or-later
// Velocity, spin and pushes that a user gives to rigid bodies.
// Scope: see the header.
#include "motion/given_motion.h"

#include <Eigen/LU>

namespace muckpile {

MovingBody moved(MovingBody body, const GivenMotion& given) {
  const Vec3 none = Vec3::Zero();
  const Vec3 turn = given.rotation.value_or(none);
  if (given.velocity || given.rotation) {
    if (!given.adds) body.velocity.setZero();
    body.velocity += given.velocity.value_or(none) + turn.cross(body.centre - given.origin);
  }
  if (given.spin || given.rotation) {
    if (!given.adds) body.spin.setZero();
    body.spin += given.spin.value_or(none) + turn;
  }
  if (given.impulse) {
    const Vec3 arm = given.at ? Vec3(*given.at - body.centre) : none;
    body.velocity += *given.impulse / body.mass;
    body.spin += body.inertia.inverse() * arm.cross(*given.impulse);
  }
  return body;
}

}  // namespace muckpile
