// SPDX-License-Identifier: GPL-2.0-or-later
// The rock and the joint classes of a network: constants derived from them.
// Scope: see the header.
#include "bond/network/joint_laws.h"

#include <algorithm>
#include <cmath>

namespace muckpile {

JointLaws::JointLaws(const JointMaterial& material, const std::vector<JointClass>& natural)
    : classes_{material}, nonlinear_{nullptr} {
  for (const JointClass& joint : natural) {
    classes_.push_back(material.with_joints(joint));
    nonlinear_.push_back(joint.law);
  }
  derive();
}

bool JointLaws::any_nonlinear() const {
  return std::ranges::any_of(nonlinear_, [](const auto& law) { return law != nullptr; });
}

void JointLaws::soften(double factor, std::optional<double> damping) {
  for (JointMaterial& material : classes_) material = material.softened(factor, damping);
  for (auto& law : nonlinear_)
    if (law != nullptr) law = law->softened(factor);
  derive();
}

void JointLaws::derive() {
  const JointParameters& parameters = rock().parameters();
  softens_ = parameters.fracture_energy_tension > 0.0 || parameters.fracture_energy_shear > 0.0;
  depends_on_rate_ = parameters.rate_exponent > 0.0;
  strengths_.clear();
  for (const JointMaterial& joint : classes_)
    strengths_.push_back(
        {{joint.parameters().tension, joint.parameters().cohesion, joint.tan_friction()},
         joint.tan_residual_friction()});
  damping_ = rock().damping_coefficient();
  contact_damping_ = rock().contact_damping_coefficient();
  shear_over_p_wave_ = 2.0 * rock().shear_modulus() / rock().p_wave_modulus();
  slip_weakening_ = {parameters.weakening_speed, std::tan(parameters.weakened_friction_angle)};
}

}  // namespace muckpile
