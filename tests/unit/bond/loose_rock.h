// SPDX-License-Identifier: GPL-2.0-or-later
// Rock whose joints break at once, and walls of broken joints that crush.
// Scope: parameters for tests.
#pragma once

#include "bond_scene.h"

namespace muckpile::test {

inline constexpr double kWalls = 50e6;  // [Pa]

/// Breaks as soon as it is pulled or slides; E 50 GPa.
inline JointParameters loose_rock(double nu, double wall_strength = kWalls) {
  JointParameters p = rock(nu);
  p.tension = p.cohesion = 0.0;
  p.friction_angle = p.residual_friction_angle = 0.5;
  p.wall_strength = wall_strength;
  return p;
}

}  // namespace muckpile::test
