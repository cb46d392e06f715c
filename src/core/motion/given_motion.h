// SPDX-License-Identifier: GPL-2.0-or-later
// Velocity, spin and pushes that a user gives to rigid bodies.
// Scope: pure functions of one body; SI units. Which bodies get it the caller knows.
#pragma once

#include <optional>

#include "math/types.h"

namespace muckpile {

/// A body as it moves.
struct MovingBody {
  double mass = 0.0;             ///< [kg]
  Mat3 inertia = Mat3::Zero();   ///< about the centre, in space [kg m2]
  Vec3 centre = Vec3::Zero();    ///< [m]
  Vec3 velocity = Vec3::Zero();  ///< of the centre [m/s]
  Vec3 spin = Vec3::Zero();      ///< [rad/s]

  [[nodiscard]] double kinetic_energy() const {
    return 0.5 * (mass * velocity.squaredNorm() + spin.dot(inertia * spin));
  }
};

/// What is not given stays as it is.
struct GivenMotion {
  std::optional<Vec3> velocity;  ///< [m/s]
  std::optional<Vec3> rotation;  ///< of all as one rigid body about `origin` [rad/s]
  Vec3 origin = Vec3::Zero();    ///< [m]
  std::optional<Vec3> spin;      ///< of each about its own centre [rad/s]
  bool adds = false;             ///< to what a body has, instead of taking its place
  std::optional<Vec3> impulse;   ///< of each, after that [N s]
  std::optional<Vec3> at;        ///< where the impulse acts; else through the centre [m]
};

/// The body after it.
[[nodiscard]] MovingBody moved(MovingBody body, const GivenMotion& given);

}  // namespace muckpile
