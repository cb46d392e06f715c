// SPDX-License-Identifier: GPL-2.0-or-later
// Force between two overlapping polyhedra: elastic pressure, damping, friction
// with memory. Scope: one contact, in any axes, all vectors seen from the first
// body's centre; SI units. No cohesion. Contacts remember a ContactState:
// `slide` is the stretch of the tangential spring [m], `roll` the angle of the
// spring against spin about the normal [rad], `overlap_offset` the share by
// which both solids are drawn in for this contact [-].
#pragma once

#include "contact/contact_law.h"
#include "contact/polyhedra/solid_overlap.h"

namespace muckpile {

/// How the first body moves against the second.
struct SolidMotion {
  Vec3 velocity;        ///< of the first's centre less that of the second's [m/s]
  Vec3 spin_first;      ///< [rad/s]
  Vec3 spin_second;     ///< [rad/s]
  Vec3 between;         ///< from the first's centre to the second's [m]
  double reduced_mass;  ///< m1 m2 / (m1 + m2) [kg]
  double twist_arm;     ///< of the spring against spin, a length of the two bodies [m]

  /// Of the first against the second at a point.
  [[nodiscard]] Vec3 at(const Vec3& point) const {
    return velocity + spin_first.cross(point) - spin_second.cross(point - between);
  }
};

struct SolidResponse {
  Vec3 force = Vec3::Zero(),
       moment = Vec3::Zero();  ///< on the first, about its centre [N], [N m]
  Vec3 dashpot_force = Vec3::Zero(),
       dashpot_moment = Vec3::Zero();              ///< part of them by dashpots
  double elastic_energy = 0.0;                     ///< [J]
  double friction_loss = 0.0, damping_loss = 0.0;  ///< in this step [J]
};

/// The springs and dashpots of a contact, sticking, and where they act.
struct SolidResistance {
  ContactResistance springs;
  Vec3 normal;       ///< unit, from the first to the second
  Vec3 point;        ///< [m]
  double spread;     ///< root mean square distance of the normal springs from there, at most [m]
  double twist_arm;  ///< distance of the tangential springs that resists spin as they do [m]
};

class SolidContactLaw {
 public:
  /// Throws InputError for a value out of range. Of the parameters `model` and
  /// `rolling_friction` are not used.
  explicit SolidContactLaw(const ContactParameters& parameters);

  /// Force of this step; `state` is taken to the end of the step. `time_step`
  /// [s] may be 0.
  [[nodiscard]] SolidResponse evaluate(const SolidOverlap& overlap, const SolidMotion& motion,
                                       double time_step, ContactState& state) const;
  [[nodiscard]] SolidResistance resistance(const SolidOverlap& overlap,
                                           const SolidMotion& motion) const;
  /// A fifth of sqrt(m / k) [s], k of two such bodies all over their stiffest
  /// faces (Solid).
  [[nodiscard]] double stable_time_step(double mass, double stiffest) const;

 private:
  /// What follows from the overlap alone.
  struct Normal {
    double modulus, force;  ///< [Pa], [N]
    Vec3 direction;         ///< unit, from the first to the second
    double energy;          ///< [J]
    double slowness;        ///< dashpot over spring force, by closing speed [s/m]
    double stiffness;       ///< [N/m]
  };
  [[nodiscard]] Normal normal_part(const SolidOverlap& overlap, double reduced_mass) const;
  static double press(const SolidOverlap& overlap, const SolidMotion& motion, const Normal& normal,
                      SolidResponse& response, double time_step);

  double half_modulus_;      ///< E* / 2, E* = E / (2 (1 - nu^2)) [Pa]
  double tangential_ratio_;  ///< k_t / k_n (Mindlin) [-]
  double damping_ratio_;     ///< [-]
  double friction_;          ///< [-]
};

}  // namespace muckpile
