// SPDX-License-Identifier: GPL-2.0-or-later
// How long a collision of two blocks lasts, on their contact spheres or on their faces.
// Scope: elastic, head-on; the step that resolves it is a matter of accuracy, not of
// stability (contact/contact_step_bound.h).
#pragma once

namespace muckpile {

/// Two bodies that meet head-on with spheres on their surfaces.
struct Collision {
  double reduced_mass;       ///< m1 m2 / (m1 + m2) of the bodies [kg]
  double reduced_radius;     ///< R1 R2 / (R1 + R2) of the spheres [m]
  double effective_modulus;  ///< E* of 1/E* = (1 - nu1^2)/E1 + (1 - nu2^2)/E2 [Pa]
  double speed;              ///< with which they approach, > 0 [m/s]
};

/// From first touch to parting [s]: 2.87 (m^2 / (R E*^2 v))^(1/5). K. L. Johnson (1985), Contact
/// Mechanics, eq. 11.24, after H. Hertz (1882).
[[nodiscard]] double hertz_collision_time(const Collision& collision);

/// How much shorter a collision is when a block has many spheres [-]: with more than 5 many smaller
/// ones touch at once. Their radius falls with n^(1/3) and stiffnesses in parallel grow with n at
/// most, so the time falls with (n/5)^(1/3).
[[nodiscard]] double crowd_factor(long spheres_per_block);

/// The smallest blocks of a rock.
struct SmallBlocks {
  double edge;               ///< of the cube that such a block half fills [m]
  double density;            ///< [kg/m3]
  long spheres;              ///< contact spheres of a block
  double effective_modulus;  ///< E* of two spheres [Pa]
  bool polyhedra = false;    ///< they touch in their own shape
};

/// Two of them meet, at `speed` [m/s], on spheres whose radius is a fifth of the edge [s]; as
/// polyhedra with whole faces, a spring of stiffness 2 E* edge, whatever the speed.
[[nodiscard]] double collision_time_of(const SmallBlocks& blocks, double speed);

}  // namespace muckpile
