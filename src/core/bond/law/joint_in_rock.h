// SPDX-License-Identifier: GPL-2.0-or-later
// The joint of a facet in series with the rock on both sides, whatever its law: points that hold
// and points that have broken. Each in two forms with the same members: by the stiffness of the
// facet where the law is grouped, and of any law. tests/unit/bond/law/test_coulomb.cpp compares
// them. Scope: pure functions of the three points of one facet; network/joint_points.h chooses the
// form.
#pragma once

#include "bond/law/joint_law.h"
#include "bond/law/linear_closure.h"

namespace muckpile {

/// A point for small motions along the normal, at the closure at which it is stiffest.
struct StiffestNormal {
  double stiffness;  ///< [Pa/m]
  double share;      ///< of the motion that strains rock, over FacetTables::rock_share() [-]
};

/// Points that hold, of a law that is grouped.
struct LinearPoints {
  LinearClosure<double> facet;

  /// By the jump, and by bulk stresses and slant: `bulk` is the traction that these make where the
  /// same share of every jump strains the rock [Pa].
  [[nodiscard]] LaneVec traction(const LaneVec& normal, const LaneVec& jump,
                                 const LaneVec& bulk) const {
    return lanes().traction(normal, jump) + bulk;
  }
  /// The jump of which that share strains as much rock [m].
  [[nodiscard]] LaneVec strained(const LaneVec& /*normal*/, const LaneVec& jump) const {
    return jump;
  }
  /// By how much that falls as the jump falls by `lost` [m].
  [[nodiscard]] LaneVec strain_lost(const LaneVec& /*normal*/, const LaneVec& /*jump*/,
                                    const LaneVec& lost) const {
    return lost;
  }
  /// Stored per area, twice [J/m2].
  [[nodiscard]] Lanes twice_energy(const LaneVec& normal, const LaneVec& jump) const {
    return lanes().twice_energy(dot(jump, jump), dot(normal, jump));
  }
  /// The bulk stress left out.
  [[nodiscard]] StiffestNormal stiffest() const { return {facet.normal(), 1.0}; }

 private:
  [[nodiscard]] LinearClosure<Lanes> lanes() const { return {facet.shear, facet.normal_extra}; }
};

/// Of any law. The jump along the normal closes joint and rock in series; what of it strains the
/// rock, r = u + closure, has the energy G/h r^2 and enters the dilatations, so that
///     t_n = [2G/h r + p] dr/du - pressure d(closure)/d(-u),
/// the joint's own pressure where the strain is uniaxial. Along the facet it is linear.
struct SeriesPoints {
  const JointLaw* law;
  double shear;       ///< stiffness [Pa/m]
  double rock;        ///< 2G/h [Pa/m]
  double uniaxial;    ///< (lambda + 2G)/h [Pa/m]
  double rock_share;  ///< of a jump along the facet that strains the rock [-]
  JointHistoryOf<Lanes> history;

  // As LinearPoints has them.
  [[nodiscard]] LaneVec traction(const LaneVec& normal, const LaneVec& jump,
                                 const LaneVec& bulk) const;
  [[nodiscard]] LaneVec strained(const LaneVec& normal, const LaneVec& jump) const;
  [[nodiscard]] LaneVec strain_lost(const LaneVec& normal, const LaneVec& jump,
                                    const LaneVec& lost) const {
    return strained(normal, jump) - strained(normal, jump - lost);
  }
  [[nodiscard]] Lanes twice_energy(const LaneVec& normal, const LaneVec& jump) const;
  [[nodiscard]] StiffestNormal stiffest() const;

  /// Of the joint alone under a jump along the normal [m].
  [[nodiscard]] Lanes closure(const Lanes& along) const { return parts(along).joint.closure; }

 private:
  /// One jump along the normal in two.
  struct Parts {
    JointClosure<Lanes> joint;
    Lanes rock;       // r [m]
    Lanes rock_rate;  // dr/du [-]
  };
  [[nodiscard]] Parts parts(const Lanes& along) const;
};

/// Points that have broken, of any law: what LinearContact is for a grouped one.
struct SeriesContact {
  const JointLaw* law;
  double fade;      ///< how far the faces match [-]
  double uniaxial;  ///< (lambda + 2G)/h [Pa/m]
  Lanes largest;    ///< closure so far [m]

  /// [Pa]; positive where the joint would be pulled open.
  [[nodiscard]] Lanes traction(const Lanes& gap) const;
  /// 0 where it is open [J/m2].
  [[nodiscard]] Lanes twice_energy(const Lanes& gap) const;
  [[nodiscard]] Lanes gap(const Lanes& traction) const;
  [[nodiscard]] Lanes stiffness_to(const Lanes& tension) const;
  [[nodiscard]] Lanes stiffest() const { return uniaxial; }

  /// Of the joint, as it is [m].
  [[nodiscard]] Lanes closure(const Lanes& gap) const;
};

}  // namespace muckpile
