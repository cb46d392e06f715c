// SPDX-License-Identifier: GPL-2.0-or-later
// The linear closure of a joint in series with the rock between two block centres: stiffness,
// traction and energy of the jump across a facet.
// Scope: pure functions of one point, one per lane. Number: double or a simd type; Vector: Vec3 or
// VectorOf<Number>. Per area of the facet; tension is positive.
#pragma once

#include "bond/law/giving_way.h"
#include "bond/law/proportional_closure.h"
#include "math/vectors.h"

namespace muckpile {

/// Stiffness of one facet whose block centres are h apart along its normal.
struct FacetStiffness {
  double normal;      ///< elastic part of the normal traction per jump [Pa/m]
  double shear;       ///< tangential traction per jump [Pa/m]
  double rock_share;  ///< share of the normal jump that strains the rock, not the joint [-]
};

/// A joint of stiffness kn and ks [Pa/m; infinite: rigid] between rock of 2G/h along the normal and
/// along the facet (`normal`, `shear`; they differ between two rocks) and (lambda + 2G)/h
/// (`uniaxial`) [Pa/m]. The share of the jump that strains the rock is exact for uniaxial strain
/// normal to the joint.
[[nodiscard]] inline FacetStiffness joint_in_rock(double normal, double shear, double uniaxial,
                                                  double kn, double ks) {
  const ProportionalClosure joint{kn};
  const double share = joint.rock_share(uniaxial);
  const double in_joint = joint.close(1.0, uniaxial, 0.0).closure;  // of a jump of 1
  return {normal * share * share + 2.0 * joint.stored(in_joint, in_joint),
          ProportionalClosure{ks}.in_series(shear), share};
}

/// Of points that hold: the part of their traction that comes from their own jump.
template <class Number>
struct LinearClosure {
  Number shear, normal_extra;  ///< stiffness; normal less shear [Pa/m]

  [[nodiscard, gnu::always_inline]] Number normal() const { return shear + normal_extra; }
  /// [Pa]
  template <class Vector>
  [[nodiscard, gnu::always_inline]] Vector traction(const Vector& normal,
                                                    const Vector& jump) const {
    return shear * jump + normal_extra * dot(normal, jump) * normal;
  }
  /// Stored per area, twice [J/m2]. `along`: the jump along the normal.
  [[nodiscard, gnu::always_inline]] Number twice_energy(const Number& jump_squared,
                                                        const Number& along) const {
    return shear * jump_squared + normal_extra * along * along;
  }
  /// Normal stiffness of the closed broken facet, rock and joint in series. With U = (lambda +
  /// 2G)/h, s the share of the rock and k the joint's own stiffness it is c = s U = (1 - s) k, and
  ///     normal = 2G/h s^2 + k (1 - s)^2 = c (s 2G/(lambda + 2G) + 1 - s).
  template <class Ratio>
  [[nodiscard, gnu::always_inline]] Number contact(const Number& rock_share,
                                                   const Ratio& shear_over_p_wave) const {
    return normal() / (1.0 - rock_share * (1.0 - shear_over_p_wave));
  }
};

/// Of points that have broken, while they are closed: along the normal.
template <class Number>
struct LinearContact {
  Number normal;  ///< stiffness [Pa/m]

  /// [Pa] `gap`: the jump along the normal from where the point carries nothing [m], not positive.
  [[nodiscard, gnu::always_inline]] Number traction(const Number& gap) const {
    return normal * gap;
  }
  [[nodiscard, gnu::always_inline]] Number twice_energy(const Number& gap) const {
    return normal * gap * gap;
  }
  /// The gap of a traction [m].
  [[nodiscard, gnu::always_inline]] Number gap(const Number& traction) const {
    return traction / normal;
  }
  /// From no traction to that tension, and anywhere [Pa/m].
  [[nodiscard, gnu::always_inline]] Number stiffness_to(const Number& /*tension*/) const {
    return normal;
  }
  [[nodiscard, gnu::always_inline]] Number stiffest() const { return normal; }
};

/// And with walls that crush, of faces that match by `fade`.
template <class Number>
struct CrushingContact : LinearContact<Number> {
  Number deepest;  ///< gap beyond which the walls crush, negative [m]

  /// `closed`: stiffness of faces that match wholly [Pa/m]; 0 where there is no facet.
  [[gnu::always_inline]] CrushingContact(const Number& fade, const Number& closed,
                                         const Number& wall_strength)
      : LinearContact<Number>{fade * closed},
        deepest(-wall_strength / max(closed, Number(1e-300))) {}
  [[nodiscard, gnu::always_inline]] CrushingWalls<Number> walls() const {
    return {-this->traction(deepest)};
  }
};

}  // namespace muckpile
