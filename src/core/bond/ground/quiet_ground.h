// SPDX-License-Identifier: GPL-2.0-or-later
// The rock behind a supported boundary facet, condensed to what the facet feels of it: the ground
// gives way like endless rock in a wave, and carries a lasting load like rock of finite thickness.
// Scope: one facet and one step, per area; SI units; no strength.
//
// Per direction, with g the displacement of the ground and t the traction that the ground puts on
// the block (as everywhere, t = stiffness x jump):
//     impedance dg/dt + stiffness g = -(t - t_0)
// impedance = rho c_P along the normal, rho c_S along the facet (Lysmer & Kuhlemeyer 1969);
// stiffness = (lambda + 2G)/L and G/L: rock of thickness L on a rigid base, at rest;
// t_0 = the static traction, which keeps the ground still when it begins to yield, carried for
// ever.
//
// Joining the dashpot to the facet instead of to the block makes the reflection of second order: a
// plane P-wave of wave number q is returned by regular blocks of size h with amplitude tan^2(q
// h/4), where a dashpot on the block itself returns tan(q h/4).
#pragma once

#include "bond/law/joint_material.h"
#include "math/types.h"

namespace muckpile {

struct QuietGround {
  double normal_impedance = 0.0, shear_impedance = 0.0;  ///< [Pa s/m]
  double normal_stiffness = 0.0, shear_stiffness = 0.0;  ///< [Pa/m]

  QuietGround() = default;
  /// `rock_behind`: thickness L [m], > 0; throws InputError otherwise.
  QuietGround(const JointMaterial& rock, double rock_behind);

  /// This one is of rock `mine`: that of `other`, of the same thickness.
  [[nodiscard]] QuietGround of_rock(const JointMaterial& mine, const JointMaterial& other) const;
};

/// Trapezoidal rule over one step: the ground ends at predicted - compliance x (t at the end).
struct GroundStep {
  double predicted;   ///< [m]
  double compliance;  ///< [m/Pa]
};

/// One direction. `displacement` [m] and `traction` [Pa] are those of the step's start,
/// `static_traction` [Pa] is part of the traction; a step of 0 s leaves the ground where it is.
[[nodiscard]] inline GroundStep ground_step(double impedance, double stiffness, double displacement,
                                            double traction, double static_traction, double dt) {
  if (dt <= 0.0) return {displacement, 0.0};
  const double compliance = dt / (2.0 * impedance + stiffness * dt);
  const double kept = (2.0 * impedance - stiffness * dt) / (2.0 * impedance + stiffness * dt);
  return {kept * displacement - compliance * (traction - 2.0 * static_traction), compliance};
}

/// What the ground behind a yielding support remembers; it travels with the facet.
struct GroundMemory {
  bool yields = false;
  Vec3 displacement = Vec3::Zero();     ///< of the ground since the start [m]
  Vec3 static_traction = Vec3::Zero();  ///< t_0: carried without moving [Pa]
  Vec3 traction = Vec3::Zero();         ///< on the block, at the end of the last step [Pa]
  /// As Facet::arm_j, before the ground moved; the network's own note, of the facet itself [m].
  Vec3 arm_j = Vec3::Zero();
  bool placed = false;  ///< arm_j is known

  void place(const Vec3& arm) {
    arm_j = arm;
    placed = true;
  }
};

}  // namespace muckpile
