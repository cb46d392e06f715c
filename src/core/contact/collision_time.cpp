// SPDX-License-Identifier: GPL-2.0-or-later
// Hertz' collision time.
// Scope: see the header.
#include "contact/collision_time.h"

#include <cmath>
#include <numbers>

namespace muckpile {

double hertz_collision_time(const Collision& c) {
  return 2.87 *
         std::pow(c.reduced_mass * c.reduced_mass /
                      (c.reduced_radius * c.effective_modulus * c.effective_modulus * c.speed),
                  0.2);
}

double crowd_factor(long spheres_per_block) {
  constexpr double kFew = 5.0;
  const auto n = static_cast<double>(spheres_per_block);
  return n > kFew ? std::cbrt(n / kFew) : 1.0;
}

double collision_time_of(const SmallBlocks& blocks, double speed) {
  const double mass = 0.5 * blocks.density * std::pow(blocks.edge, 3.0);
  if (blocks.polyhedra)
    return std::numbers::pi *
           std::sqrt(0.5 * mass / (2.0 * blocks.effective_modulus * blocks.edge));
  const double radius = 0.2 * blocks.edge;
  return hertz_collision_time({.reduced_mass = 0.5 * mass,
                               .reduced_radius = 0.5 * radius,
                               .effective_modulus = blocks.effective_modulus,
                               .speed = speed}) /
         crowd_factor(blocks.spheres);
}

}  // namespace muckpile
