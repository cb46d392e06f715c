// SPDX-License-Identifier: GPL-2.0-or-later
// Elastic constants of the rock and strength of the joints: validation and derived numbers.
// Scope: see the header.
#include "bond/law/joint_material.h"

#include <cmath>
#include <string>

#include "args/require.h"

namespace muckpile {
namespace {

constexpr double kRightAngle = 1.5707963267948966;

}  // namespace

JointMaterial::JointMaterial(const JointParameters& parameters)
    : parameters_(parameters),
      shear_modulus_(parameters.youngs_modulus / (2.0 * (1.0 + parameters.poisson_ratio))),
      lame_lambda_(2.0 * shear_modulus_ * parameters.poisson_ratio /
                   (1.0 - 2.0 * parameters.poisson_ratio)),
      tan_friction_(std::tan(parameters.friction_angle)),
      tan_residual_friction_(std::tan(parameters.residual_friction_angle)) {
  const JointParameters& p = parameters_;
  require(p.youngs_modulus > 0.0, "youngs_modulus must be > 0 Pa", p.youngs_modulus);
  require(p.poisson_ratio >= 0.0 && p.poisson_ratio < 0.5, "poisson_ratio must be in [0, 0.5)",
          p.poisson_ratio);
  require(p.density > 0.0, "density must be > 0 kg/m3", p.density);
  require(p.tension >= 0.0, "tension must be >= 0 Pa", p.tension);
  require(p.cohesion >= 0.0, "cohesion must be >= 0 Pa", p.cohesion);
  require(p.friction_angle >= 0.0 && p.friction_angle < kRightAngle,
          "friction_angle must be in [0, 90) degrees, in radians here", p.friction_angle);
  require(p.residual_friction_angle >= 0.0 && p.residual_friction_angle < kRightAngle,
          "residual_friction_angle must be in [0, 90) degrees, in radians here",
          p.residual_friction_angle);
  require(p.normal_stiffness > 0.0, "normal_stiffness must be > 0 Pa/m", p.normal_stiffness);
  require(p.shear_stiffness > 0.0, "shear_stiffness must be > 0 Pa/m", p.shear_stiffness);
  require(p.damping >= 0.0, "damping must be >= 0", p.damping);
  require(p.contact_damping >= 0.0, "contact_damping must be >= 0", p.contact_damping);
  require(p.fracture_energy_tension >= 0.0, "fracture_energy_tension must be >= 0 J/m2",
          p.fracture_energy_tension);
  require(p.fracture_energy_shear >= 0.0, "fracture_energy_shear must be >= 0 J/m2",
          p.fracture_energy_shear);
  require(p.rate_exponent >= 0.0, "rate_exponent must be >= 0", p.rate_exponent);
  require(p.reference_rate > 0.0, "reference_rate must be > 0 1/s", p.reference_rate);
  require(p.reference_rate_shear > 0.0, "reference_rate_shear must be > 0 1/s",
          p.reference_rate_shear);
  require(p.weakening_speed >= 0.0, "weakening_speed must be >= 0 m/s", p.weakening_speed);
  require(p.weakened_friction_angle >= 0.0 && p.weakened_friction_angle < kRightAngle,
          "weakened_friction_angle must be in [0, 90) degrees, in radians here",
          p.weakened_friction_angle);
  require(p.wall_strength >= 1e5, "wall_strength must be 0 or >= 1e+05 Pa", p.wall_strength);
}

double JointMaterial::p_wave_modulus() const { return lame_lambda_ + 2.0 * shear_modulus_; }

double JointMaterial::p_wave_speed() const {
  return std::sqrt(p_wave_modulus() / parameters_.density);
}

double JointMaterial::s_wave_speed() const {
  return std::sqrt(shear_modulus_ / parameters_.density);
}

double JointMaterial::damping_coefficient() const {
  return parameters_.damping * parameters_.density * p_wave_speed();
}

double JointMaterial::contact_damping_coefficient() const {
  return parameters_.contact_damping * parameters_.density * p_wave_speed();
}

FacetStiffness JointMaterial::facet_stiffness(double h) const {
  return joint_in_rock(2.0 * shear_modulus_ / h, 2.0 * shear_modulus_ / h, p_wave_modulus() / h,
                       parameters_.normal_stiffness, parameters_.shear_stiffness);
}

JointMaterial JointMaterial::with_joints(const JointClass& joint) const {
  JointParameters p = parameters_;
  p.tension = joint.tension;
  p.cohesion = joint.cohesion;
  p.friction_angle = joint.friction_angle;
  p.residual_friction_angle = joint.residual_friction_angle;
  p.normal_stiffness = joint.normal_stiffness;
  p.shear_stiffness = joint.shear_stiffness;
  if (joint.wall_strength > 0.0) p.wall_strength = joint.wall_strength;
  // Energy is taken as a strength falls: none where the joint has no such strength of its own. What
  // friction loses as it falls to the residual is no cohesion and goes with the pressure.
  if (joint.tension == 0.0) p.fracture_energy_tension = 0.0;
  if (joint.cohesion == 0.0) p.fracture_energy_shear = 0.0;
  return JointMaterial(p);
}

JointMaterial JointMaterial::softened(double factor, std::optional<double> damping) const {
  JointParameters p = parameters_;
  if (damping) p.damping = p.contact_damping = *damping;
  p.youngs_modulus *= factor;
  p.normal_stiffness *= factor;
  p.shear_stiffness *= factor;
  return JointMaterial(p);
}

}  // namespace muckpile
