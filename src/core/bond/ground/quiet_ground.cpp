// SPDX-License-Identifier: GPL-2.0-or-later
// The rock behind a supported boundary facet: constants of the rock.
// Scope: see the header.
#include "bond/ground/quiet_ground.h"

#include <string>

#include "args/input_error.h"

namespace muckpile {

QuietGround::QuietGround(const JointMaterial& rock, double rock_behind) {
  if (!(rock_behind > 0.0))
    throw InputError("rock_behind must be > 0 m, got '" + std::to_string(rock_behind) + "'");
  const double density = rock.parameters().density;
  normal_impedance = density * rock.p_wave_speed();
  shear_impedance = density * rock.s_wave_speed();
  normal_stiffness = rock.p_wave_modulus() / rock_behind;
  shear_stiffness = rock.shear_modulus() / rock_behind;
}

QuietGround QuietGround::of_rock(const JointMaterial& mine, const JointMaterial& other) const {
  const double density = other.parameters().density / mine.parameters().density;
  QuietGround ground;
  ground.normal_impedance = normal_impedance * density * other.p_wave_speed() / mine.p_wave_speed();
  ground.shear_impedance = shear_impedance * density * other.s_wave_speed() / mine.s_wave_speed();
  ground.normal_stiffness = normal_stiffness * other.p_wave_modulus() / mine.p_wave_modulus();
  ground.shear_stiffness = shear_stiffness * other.shear_modulus() / mine.shear_modulus();
  return ground;
}

}  // namespace muckpile
