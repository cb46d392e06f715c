// SPDX-License-Identifier: GPL-2.0-or-later
// A facet between two rocks.
// Scope: see the header.
#include "bond/law/two_rocks.h"

#include <algorithm>

namespace muckpile {

TwoRocks two_rocks(const JointMaterial& rock_i, double depth_i, const JointMaterial& rock_j,
                   double depth_j) {
  const double h = depth_i + depth_j;
  TwoRocks both;
  both.uniaxial = 1.0 / (depth_i / rock_i.p_wave_modulus() + depth_j / rock_j.p_wave_modulus());
  both.shear =
      1.0 / (0.5 * depth_i / rock_i.shear_modulus() + 0.5 * depth_j / rock_j.shear_modulus());
  const auto side = [&](std::size_t k, const JointMaterial& rock, double depth) {
    const double strain = both.uniaxial / rock.p_wave_modulus();  // per jump [1/m]
    both.normal += 2.0 * rock.shear_modulus() * depth * strain * strain;
    both.along[k] = h * strain;
    both.across[k] = 0.5 * h * both.shear / rock.shear_modulus();
  };
  side(0, rock_i, depth_i);
  side(1, rock_j, depth_j);
  return both;
}

JointParameters weaker_of(const JointParameters& a, const JointParameters& b) {
  JointParameters weaker = a;
  for (double JointParameters::*least :
       {&JointParameters::tension, &JointParameters::cohesion, &JointParameters::friction_angle,
        &JointParameters::residual_friction_angle, &JointParameters::normal_stiffness,
        &JointParameters::shear_stiffness, &JointParameters::damping,
        &JointParameters::contact_damping, &JointParameters::fracture_energy_tension,
        &JointParameters::fracture_energy_shear, &JointParameters::rate_exponent,
        &JointParameters::wall_strength})
    weaker.*least = std::min(a.*least, b.*least);
  for (double JointParameters::*greatest :
       {&JointParameters::reference_rate, &JointParameters::reference_rate_shear})
    weaker.*greatest = std::max(a.*greatest, b.*greatest);
  return weaker;
}

}  // namespace muckpile
