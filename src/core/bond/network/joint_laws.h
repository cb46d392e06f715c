// SPDX-License-Identifier: GPL-2.0-or-later
// The rock and the joint classes of a network, with the constants that the passes over facets read.
// Scope: constants; they change only as the rock is softened. SI units. The laws themselves are in
// bond/law.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "bond/law/coulomb.h"
#include "bond/law/joint_law.h"
#include "bond/law/joint_material.h"
#include "bond/law/linear_closure.h"
#include "bond/law/slip_friction.h"

namespace muckpile {

/// Of a joint class.
struct JointStrength {
  CoulombStrength<double> bonded;
  double tan_residual;  ///< of slow slip [-]
};

class JointLaws {
 public:
  /// `natural`: the joint classes from 1; class 0 is that of `material`.
  JointLaws(const JointMaterial& material, const std::vector<JointClass>& natural);

  [[nodiscard]] const JointMaterial& rock() const { return classes_.front(); }
  [[nodiscard]] const JointMaterial& of_class(std::size_t joint_class) const {
    return classes_.at(joint_class);
  }
  [[nodiscard]] std::size_t natural_classes() const { return classes_.size() - 1; }
  [[nodiscard]] const JointStrength& strength(std::size_t joint_class) const {
    return strengths_[joint_class];
  }

  /// The nonlinear law of a class; nullptr: it has the linear one.
  [[nodiscard]] const JointLaw* nonlinear(std::size_t joint_class) const {
    return nonlinear_[joint_class].get();
  }
  [[nodiscard]] bool any_nonlinear() const;

  /// Every stiffness times `factor`; `damping`, a share of the impedance, replaces that of all
  /// classes.
  void soften(double factor, std::optional<double> damping);

  /// A point that has reached its strength sheds its traction gradually.
  [[nodiscard]] bool softens() const { return softens_; }
  /// Strength grows with the rate of strain.
  [[nodiscard]] bool depends_on_rate() const { return depends_on_rate_; }
  [[nodiscard]] double damping() const { return damping_; }  ///< of bonded points [Pa s/m]
  [[nodiscard]] double contact_damping() const { return contact_damping_; }  ///< [Pa s/m]
  [[nodiscard]] const SlipWeakening& slip_weakening() const { return slip_weakening_; }
  /// Of the linear law; `tan_residual`: of slow slip [-].
  template <class Number>
  [[nodiscard, gnu::always_inline]] SlipFriction<Number> friction(
      const Number& tan_residual) const {
    return {tan_residual, slip_weakening_};
  }
  [[nodiscard]] double shear_over_p_wave() const { return shear_over_p_wave_; }  ///< [-]

  /// Stiffness along the normal of the closed broken facet whose bonded points have that closure.
  template <class Number>
  [[nodiscard, gnu::always_inline]] LinearContact<Number> contact(
      const LinearClosure<Number>& bonded, const Number& rock_share) const {
    return {bonded.contact(rock_share, shear_over_p_wave_)};
  }

 private:
  void derive();

  std::vector<JointMaterial> classes_;  // the rock is the same in all
  std::vector<JointStrength> strengths_;
  std::vector<std::shared_ptr<const JointLaw>> nonlinear_;
  bool softens_ = false, depends_on_rate_ = false;
  double damping_ = 0.0, contact_damping_ = 0.0;
  double shear_over_p_wave_ = 1.0;  // 2G/(lambda + 2G) [-]
  SlipWeakening slip_weakening_;
};

}  // namespace muckpile
