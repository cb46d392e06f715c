// SPDX-License-Identifier: GPL-2.0-or-later
// The law of a facet's joint: closure, strength, friction, and the apertures that gas finds.
// Scope: the interface that the facet network calls, for the points of one facet at once; how to
// add a law is in CONTRIBUTING.md. Laws themselves are value types templated on the number type,
// which JointLawOf turns into this.
#pragma once

#include <algorithm>
#include <concepts>
#include <memory>
#include <optional>
#include <utility>

#include "bond/law/joint_material.h"
#include "bond/law/proportional_closure.h"
#include "bond/law/strength.h"
#include "math/lanes.h"

namespace muckpile {

/// What a point of such a joint remembers; it travels with the facet.
struct JointHistory {
  double closure = 0.0;   ///< largest so far [m]
  double slip = 0.0;      ///< since it broke [m]
  double broke_at = 0.0;  ///< closure just after it broke [m]

  [[nodiscard]] bool empty() const { return closure == 0.0 && slip == 0.0 && broke_at == 0.0; }
};
/// Of the points of a facet.
template <class Number>
struct JointHistoryOf {
  Number closure = 0.0, slip = 0.0;
};

/// Of a joint, for gas.
struct JointApertures {
  double mechanical;  ///< between its walls: the gas has this volume per area [m]
  double hydraulic;   ///< between smooth walls that let as much through [m]
};

/// Closure c, pressure s(c) and largest closure c_r so far of a point. What a law must keep to:
/// - s(c) is one number for each c_r, grows with c, and so does ds/dc, or stays, along each branch,
///   on which the bound of the time step relies. It is negative exactly where the joint is
///   pulled open; first loading and loading again meet at c_r. So close() has one solution, its
///   closure and pressure grow with the jump, and rate is U/(U + ds/dc), U the rock's stiffness.
/// - stored() is the integral of s along the branch that unloading takes, 0 where s is, also for
///   pulled open joints, which store what s does up to there. taken(c_r) is first loading's
///   integral up to c_r less stored(c_r, c_r); it never falls. The energy account then balances.
/// - Strength and friction see the shear squared or not at all: no direction of slip. friction() is
///   shear over pressure, not a traction. Slip cannot dilate the joint: closure and slip are
///   apart, and along the facet the joint is linear (JointClass::shear_stiffness).
/// - A facet has three points: the last of the four Lanes is none. Every member that takes Lanes
///   reaches it too, with history 0 and the jump of the facet's centre, and must be finite there.
/// - Largest closure and slip are all that a point remembers (JointHistory); both only grow.
/// - Apertures are > 0 at every closure, the mechanical one falls by what the closure grows.
class JointLaw {
 public:
  explicit JointLaw(bool grouped) : grouped_(grouped) {}
  JointLaw(const JointLaw&) = default;
  JointLaw& operator=(const JointLaw&) = default;
  virtual ~JointLaw() = default;

  /// Closure is a ProportionalClosure, strength and friction are a CoulombStrength, there are no
  /// apertures: points remember nothing, and facets are worked on in groups by their stiffness
  /// (law/joint_in_rock.h) and by strength(). Those of all other laws are worked on one by one.
  [[nodiscard]] bool grouped() const { return grouped_; }
  /// Of a law that is grouped; its fails() and friction() say the same.
  [[nodiscard]] virtual CoulombStrength<double> strength() const = 0;

  /// Of joint and rock squeezed by `jump` [m] together; `rock` is the rock's stiffness [Pa/m].
  [[nodiscard]] virtual JointClosure<Lanes> close(const Lanes& jump, double rock,
                                                  const Lanes& largest) const = 0;
  /// The jump at which they carry that pressure [Pa] -> [m]: the inverse of close().
  [[nodiscard]] virtual Lanes jump_at(const Lanes& pressure, double rock,
                                      const Lanes& largest) const = 0;
  /// Energy in the joint that unloading gives back, and energy taken for good so far [J/m2].
  [[nodiscard]] virtual Lanes stored(const Lanes& closure, const Lanes& largest) const = 0;
  [[nodiscard]] virtual Lanes taken(const Lanes& largest) const = 0;
  /// Whether bonded points fail; `normal` traction is positive in tension [Pa], the whole shear
  /// squared [Pa2].
  [[nodiscard]] virtual LaneMask fails(const Lanes& normal, const Lanes& shear_squared,
                                       const StrengthFactors<Lanes>& factors) const = 0;
  /// Friction of broken points at slow slip under a pressure [Pa], after a slip [m] -> [-]; finite
  /// at pressure 0 too.
  [[nodiscard]] virtual Lanes friction(const Lanes& pressure, const Lanes& slip) const = 0;
  /// What gas finds at that closure [m]; none at any: cracks through the rock are as wide as the
  /// facet is open.
  [[nodiscard]] virtual std::optional<JointApertures> apertures(double closure) const = 0;
  /// The same joint with every stiffness times `factor`.
  [[nodiscard]] virtual std::shared_ptr<const JointLaw> softened(double factor) const = 0;

 private:
  bool grouped_;
};

template <class Law>
concept GroupedJoint = Law::kGrouped;

/// A law's value type `Law` as a JointLaw. Its member functions are those of above, templated on
/// the number type.
template <class Law>
class JointLawOf : public JointLaw {
 public:
  static_assert(!GroupedJoint<Law> || (std::derived_from<Law, CoulombStrength<double>> &&
                                       std::derived_from<Law, ProportionalClosure>),
                "facets of a grouped law are worked on by these two");
  explicit JointLawOf(Law law) : JointLaw(GroupedJoint<Law>), law_(std::move(law)) {}
  [[nodiscard]] CoulombStrength<double> strength() const override {
    if constexpr (GroupedJoint<Law>) return law_;
    return {};
  }
  [[nodiscard]] JointClosure<Lanes> close(const Lanes& jump, double rock,
                                          const Lanes& largest) const override {
    return law_.close(jump, rock, largest);
  }
  [[nodiscard]] Lanes jump_at(const Lanes& pressure, double rock,
                              const Lanes& largest) const override {
    return law_.jump_at(pressure, rock, largest);
  }
  [[nodiscard]] Lanes stored(const Lanes& closure, const Lanes& largest) const override {
    return law_.stored(closure, largest);
  }
  [[nodiscard]] Lanes taken(const Lanes& largest) const override { return law_.taken(largest); }
  [[nodiscard]] LaneMask fails(const Lanes& normal, const Lanes& shear_squared,
                               const StrengthFactors<Lanes>& factors) const override {
    return law_.fails(normal, shear_squared, factors);
  }
  [[nodiscard]] Lanes friction(const Lanes& pressure, const Lanes& slip) const override {
    return law_.friction(pressure, slip);
  }
  [[nodiscard]] std::optional<JointApertures> apertures(double closure) const override {
    return law_.apertures(closure);
  }
  [[nodiscard]] std::shared_ptr<const JointLaw> softened(double factor) const override {
    return std::make_shared<JointLawOf>(law_.softened(factor));
  }

 private:
  Law law_;
};

/// The same law wherever the joint is, for JointClass::law.
template <class Law>
[[nodiscard]] JointLawMaker law_everywhere(const Law& law) {
  return [joint = std::make_shared<JointLawOf<Law>>(law)](const JointMaterial&) { return joint; };
}

}  // namespace muckpile
