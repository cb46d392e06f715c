// SPDX-License-Identifier: GPL-2.0-or-later
// What a class of natural joints may have instead of the linear closure with Coulomb's strength, a
// nonlinear joint law: closure, strength, friction, and the apertures that gas finds.
// Scope: the interface that the facet network calls, for the points of one facet at once; how to
// add a law is in CONTRIBUTING.md. Laws themselves are value types templated on the number type,
// which NonlinearJointLaw turns into this.
#pragma once

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

#include "bond/law/slip_friction.h"
#include "math/lanes.h"

namespace muckpile {

/// What a point of such a joint remembers; it travels with the facet.
struct JointHistory {
  double closure = 0.0;    ///< largest so far [m]
  double slip = 0.0;       ///< since it broke [m]
  double broke_at = 0.0;   ///< closure just after it broke [m]
};
/// Of the points of a facet.
template <class Number>
struct JointHistoryOf {
  Number closure = 0.0, slip = 0.0;
};

/// A joint closed in series with the rock on both sides.
template <class Number>
struct JointClosure {
  Number closure;   ///< of the joint; negative where it is pulled open [m]
  Number pressure;  ///< positive in compression [Pa]
  Number rate;      ///< of the closure per jump of joint and rock together, between 0 and 1 [-]
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
  JointLaw() = default;
  JointLaw(const JointLaw&) = default;
  JointLaw& operator=(const JointLaw&) = default;
  virtual ~JointLaw() = default;

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
  /// squared [Pa2]; `faster`: tensile strength over that at rest; 0 where a point has slipped and
  /// opens.
  [[nodiscard]] virtual LaneMask fails(const Lanes& normal, const Lanes& shear_squared,
                                       const Lanes& faster) const = 0;
  /// Friction of broken points at slow slip under a pressure [Pa], after a slip [m] -> [-]; finite
  /// at pressure 0 too.
  [[nodiscard]] virtual Lanes friction(const Lanes& pressure, const Lanes& slip) const = 0;
  /// What gas finds at that closure [m]; none: as in joints with the linear law.
  [[nodiscard]] virtual std::optional<JointApertures> apertures(double closure) const = 0;
  /// The same joint with every stiffness times `factor`.
  [[nodiscard]] virtual std::shared_ptr<const JointLaw> softened(double factor) const = 0;
};

/// A law's value type `Law` as a JointLaw. Its member functions are those of above, templated on
/// the number type.
template <class Law>
class NonlinearJointLaw : public JointLaw {
 public:
  explicit NonlinearJointLaw(Law law) : law_(std::move(law)) {}
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
                               const Lanes& faster) const override {
    return law_.fails(normal, shear_squared, faster);
  }
  [[nodiscard]] Lanes friction(const Lanes& pressure, const Lanes& slip) const override {
    return law_.friction(pressure, slip);
  }
  [[nodiscard]] std::optional<JointApertures> apertures(double closure) const override {
    return law_.apertures(closure);
  }
  [[nodiscard]] std::shared_ptr<const JointLaw> softened(double factor) const override {
    return std::make_shared<NonlinearJointLaw>(law_.softened(factor));
  }

 private:
  Law law_;
};

/// Points of a facet that hold, with a joint of a nonlinear law: what LinearClosure is for the
/// linear one. The jump along the normal closes joint and rock in series; what of it strains the
/// rock, r = u + closure, has the energy G/h r^2 and enters the dilatations, so that
///     t_n = [2G/h r + p] dr/du - pressure d(closure)/d(-u),
/// the joint's own pressure where the strain is uniaxial. Along the facet it is linear.
struct NonlinearClosure {
  const JointLaw* law;
  double shear;       ///< stiffness [Pa/m]
  double rock;        ///< 2G/h [Pa/m]
  double uniaxial;    ///< (lambda + 2G)/h [Pa/m]
  double rock_share;  ///< of a jump along the facet that strains the rock [-]
  JointHistoryOf<Lanes> history;

  /// One jump along the normal in two.
  struct Parts {
    JointClosure<Lanes> joint;
    Lanes rock;       ///< r [m]
    Lanes rock_rate;  ///< dr/du [-]
  };
  [[nodiscard]] Parts parts(const Lanes& along) const;
  /// By the jump alone [Pa].
  [[nodiscard]] LaneVec traction(const LaneVec& normal, const LaneVec& jump) const;
  /// By bulk stresses and slant, given the traction that they make where the share of rock_share
  /// of every jump strains the rock [Pa].
  [[nodiscard]] LaneVec passed_on(const LaneVec& normal, const LaneVec& jump,
                                  const LaneVec& traction) const;
  /// The jump of which that share strains as much rock [m].
  [[nodiscard]] LaneVec strained(const LaneVec& normal, const LaneVec& jump) const;
  /// Stored per area, twice [J/m2].
  [[nodiscard]] Lanes twice_energy(const LaneVec& normal, const LaneVec& jump) const;
  /// The largest stiffness along the normal for small motions, at whatever closure, the bulk stress
  /// left out [Pa/m].
  [[nodiscard]] double stiffest() const;
};

/// Points of a facet that have broken: what LinearContact is for the linear law.
struct NonlinearContact {
  const JointLaw* law;
  double fade;      ///< how far the faces match [-]
  double uniaxial;  ///< (lambda + 2G)/h [Pa/m]
  Lanes largest;    ///< closure so far [m]

  /// [Pa]; positive where the joint would be pulled open.
  [[nodiscard]] Lanes traction(const Lanes& gap) const;
  /// Of the joint, as it is [m].
  [[nodiscard]] Lanes closure(const Lanes& gap) const;
  /// 0 where it is open [J/m2].
  [[nodiscard]] Lanes twice_energy(const Lanes& gap) const;
  [[nodiscard]] Lanes gap(const Lanes& traction) const;
};

/// What SlipFriction is for the linear law.
struct NonlinearFriction {
  const JointLaw* law;
  Lanes slip;  ///< since it broke [m]
  SlipWeakening weakening{};

  [[nodiscard]] Lanes limit(const Lanes& normal, const Lanes& speed_squared) const {
    return SlipFriction<Lanes>{law->friction(-normal, slip), weakening}.limit(normal,
                                                                              speed_squared);
  }
};

}  // namespace muckpile
