// SPDX-License-Identifier: GPL-2.0-or-later
// The rocks and the joint classes of a network: constants derived from them.
// Scope: see the header.
#include "bond/network/joint_laws.h"

#include <algorithm>
#include <cmath>
#include <ranges>
#include <string>

#include "args/input_error.h"
#include "args/numbers.h"
#include "bond/law/two_rocks.h"

namespace muckpile {

JointLaws::JointLaws(const JointMaterial& material, const std::vector<JointClass>& natural,
                     const std::vector<JointMaterial>& zones)
    : natural_classes_(natural.size()), rocks_{material} {
  rocks_.insert(rocks_.end(), zones.begin(), zones.end());
  if ((natural.size() + 1) * rocks_.size() * rocks_.size() > kMost)
    throw InputError("(joint classes + 1) (zones + 1)^2 must be <= " + std::to_string(kMost) +
                     ", got " + std::to_string(natural.size()) + " classes and " +
                     std::to_string(zones.size()) + " zones");
  const JointLawMaker of_rock = coulomb_law();
  for (std::size_t k = 0; k <= natural.size(); ++k) {
    for (const JointMaterial& i : rocks_)
      for (const JointMaterial& j : rocks_) {
        const JointMaterial between =
            &i == &j ? i : JointMaterial(weaker_of(i.parameters(), j.parameters()));
        laws_.push_back(k == 0 ? between : between.with_joints(natural[k - 1]));
        joints_.push_back((k == 0 ? of_rock : natural[k - 1].law)(laws_.back()));
      }
  }
  derive();
  const auto strength_of = [](const JointMaterial& law) { return law.parameters().wall_strength; };
  if (crushes_ && any_alone())
    throw InputError(
        "wall_strength of the rock, of zones and of classes with law coulomb must be 0 beside a "
        "joint_class with another law, got '" +
        number_text(std::ranges::min(laws_ | std::views::transform(strength_of))) + "'");
}

bool JointLaws::any_alone() const {
  return std::ranges::any_of(joints_, [](const auto& law) { return !law->grouped(); });
}

void JointLaws::soften(double factor, std::optional<double> damping) {
  for (JointMaterial& material : rocks_) material = material.softened(factor, damping);
  for (JointMaterial& material : laws_) material = material.softened(factor, damping);
  for (auto& law : joints_) law = law->softened(factor);
  derive();
}

void JointLaws::derive() {
  softens_ = crushes_ = depends_on_rate_ = damps_ = false;
  strengths_.clear();
  damping_.clear();
  contact_damping_.clear();
  shear_over_p_wave_.clear();
  for (std::size_t law = 0; law < laws_.size(); ++law) {
    const JointMaterial& joint = laws_[law];
    const JointMaterial& turned = laws_[law_of(class_of(law), zone_j(law), zone_i(law))];
    const JointParameters& p = joint.parameters();
    softens_ = softens_ || p.fracture_energy_tension > 0.0 || p.fracture_energy_shear > 0.0;
    crushes_ = crushes_ || std::isfinite(p.wall_strength);
    depends_on_rate_ = depends_on_rate_ || p.rate_exponent > 0.0;
    strengths_.push_back(joints_[law]->strength());
    // Both have the lesser share, each of the impedance of its own rock i.
    damping_.push_back(std::min(joint.damping_coefficient(), turned.damping_coefficient()));
    contact_damping_.push_back(
        std::min(joint.contact_damping_coefficient(), turned.contact_damping_coefficient()));
    damps_ = damps_ || damping_.back() != 0.0;
  }
  for (const JointMaterial& rock : rocks_)
    shear_over_p_wave_.push_back(2.0 * rock.shear_modulus() / rock.p_wave_modulus());
  const JointParameters& parameters = rock().parameters();
  slip_weakening_ = {parameters.weakening_speed, std::tan(parameters.weakened_friction_angle)};
}

}  // namespace muckpile
