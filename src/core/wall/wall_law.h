// SPDX-License-Identifier: GPL-2.0-or-later
// Force of a wall that stands still on one sphere, and what the sphere remembers of it.
// Scope: the law of sphere contacts (contact/contact_law.h); SI units.
#pragma once

#include <vector>

#include "contact/contact_law.h"
#include "wall/wall_surface.h"

namespace muckpile {

/// What a sphere remembers of a touch.
struct WallContact {
  Vec3 normal = Vec3::Zero();  ///< of the last step
  ContactState state;
  double twist = 0.0;    ///< of the spring against spin about the normal [rad]
  double overlap = 0.0;  ///< of the last step [m]
};

/// A sphere of a block.
struct WallSphere {
  Vec3 centre, velocity, spin;  ///< [m], [m/s], [rad/s]
  double radius;                ///< [m]
  double mass;                  ///< of its block [kg]
};

/// What the wall does to a sphere in a step.
struct WallPush {
  Vec3 force = Vec3::Zero();   ///< [N]
  Vec3 torque = Vec3::Zero();  ///< about the sphere's centre [N m]
  int contacts = 0;
  double elastic = 0.0;                ///< stored [J]
  double friction = 0.0;               ///< lost in the step [J]
  double damping = 0.0;                ///< lost in the step [J]
  double largest_overlap_ratio = 0.0;  ///< over the radius [-]
};

/// Blocks of one rock on ground that may be stiffer: the modulus that the law of two equal
/// materials needs so that their contact is as stiff. Poisson's ratio is that of the rock.
[[nodiscard]] double modulus_against(double rock_modulus, double ground_modulus);

class WallLaw {
 public:
  /// `torsion`: spin about the normal is resisted as rolling is, and both together by one limit.
  /// Throws InputError for a value out of range.
  explicit WallLaw(const ContactParameters& parameters, bool torsion = false);

  /// Takes `contacts` to the end of the step: those of `touches`, in their order. A touch goes on
  /// with the memory of that whose normal was most like its own, on whatever triangle it was.
  /// `time_step` of the run [s]; with `memory_step` 0 [s], else the same, contacts stay as they
  /// are.
  [[nodiscard]] WallPush push(const WallSphere& sphere, const WallTouches& touches,
                              double time_step, double memory_step,
                              std::vector<WallContact>& contacts) const;

  /// Springs and dashpots of a contact, sticking, for the time step that it bears.
  [[nodiscard]] ContactResistance resistance(const WallSphere& sphere,
                                             const WallContact& contact) const;
  /// From the centre of a sphere to where the force of a contact acts [m].
  [[nodiscard]] static Vec3 arm(double radius, const WallContact& contact);

  /// Resolves a light collision of a block with the wall [s], see ContactLaw.
  [[nodiscard]] double light_step(double mass, double radius) const {
    return law_.stable_time_step(mass, radius);
  }

 private:
  struct Turn {
    Vec3 torque = Vec3::Zero();            ///< [N m]
    double elastic = 0.0, friction = 0.0;  ///< [J]
  };
  [[nodiscard]] Turn turn(const WallContact& before, const Vec3& angle, double normal_force,
                          double radius, WallContact& contact) const;

  ContactLaw law_;                 ///< without rolling resistance where there is torsion
  double turning_friction_ = 0.0;  ///< limit torque over radius times normal force, 0: no torsion
};

}  // namespace muckpile
