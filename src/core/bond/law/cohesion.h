// SPDX-License-Identifier: GPL-2.0-or-later
// Softening by fracture energy: what a point of a facet still holds after its strength is reached;
// and how strength grows with the rate of strain.
// Scope: pure functions of one point, one per lane; vectors in the facet's own axes (normal first).
//
// Linear weakening (Hillerborg, Modeer & Petersson 1976 in tension; the like in shear with friction
// beside it, and unloading towards the origin, as of Camacho & Ortiz 1996): the traction that
// breaking would drop at once falls to zero as the two sides part along it. The elastic jump before
// breaking is a part of the parting, so that all that the facet takes is its fracture energy,
// whatever the size of the blocks.
#pragma once

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "bond/law/joint_material.h"
#include "math/lanes.h"
#include "math/powers.h"
#include "math/types.h"

namespace muckpile {

/// Of a point, or of one per lane of Number.
template <class Number>
struct CohesionOf {
  using Vector = std::conditional_t<std::is_same_v<Number, double>, Vec3, VectorOf<Number>>;

  Vector direction{Vec3(Vec3::Zero())};  ///< unit, of the traction on block i
  Number strength = 0.0;                 ///< at its start [Pa]
  Number first = 0.0;                    ///< parting at its start [m]
  Number end = 0.0;    ///< parting at which nothing is left [m]; 0: nothing is left
  Number worst = 0.0;  ///< largest parting so far [m]
  Number shift = 0.0;  ///< jump along the direction without parting [m]

  [[nodiscard]] auto holds() const { return end > 0.0; }
  [[nodiscard]] Number parting(const Vector& jump) const { return dot(direction, jump) - shift; }
  /// [Pa]; unloading and loading again run along the line to the origin.
  [[nodiscard]] Number traction(const Number& parting, const Number& largest) const {
    using std::max;
    const Number held = strength * (end - largest) / (end - first);
    return choose(largest >= end, Number(0.0), held * max(parting, Number(0.0)) / largest);
  }
  /// Stored per area [J/m2].
  [[nodiscard]] Number energy(const Number& parting) const {
    using std::max;
    return 0.5 * traction(parting, worst) * max(parting, Number(0.0));
  }
};
using Cohesion = CohesionOf<double>;

/// `dropped`: what breaking would drop at once [Pa], with the stiffness of the facet normal to it
/// and along it [Pa/m]. Holds nothing if the fracture energy is 0, or no more than the elastic
/// energy at the strength: then blocks are too large for it.
[[nodiscard]] inline Cohesion cohesion_after(const Vec3& dropped, const Vec3& jump,
                                             double normal_stiffness, double shear_stiffness,
                                             const JointParameters& p) {
  const double size = dropped.norm();
  Cohesion c;
  if (size == 0.0 || shear_stiffness == 0.0) return c;
  const double opens = std::pow(dropped.x() / size, 2);  // share of the energy that is tension's
  const double toughness =
      opens * p.fracture_energy_tension + (1.0 - opens) * p.fracture_energy_shear;
  const double first = size * (opens / normal_stiffness + (1.0 - opens) / shear_stiffness);
  const double end = 2.0 * toughness / size;
  if (end <= first) return c;
  c.direction = dropped / size;
  c.strength = size;
  c.first = c.worst = first;
  c.end = end;
  c.shift = c.direction.dot(jump) - first;
  return c;
}

/// Strength over its value at rest: (rate / reference)^exponent, at least 1; the form of one branch
/// of the CEB-FIP Model Code 1990.
[[nodiscard]] inline double rate_factor(double strain_rate, double reference_rate,
                                        double exponent) {
  return power_of(std::max(1.0, strain_rate / reference_rate), exponent);
}

}  // namespace muckpile
