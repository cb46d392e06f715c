// SPDX-License-Identifier: GPL-2.0-or-later
// Contacts for the time step that they bear, where a sphere may lie on another rank than that which
// moves its body.
// Scope: one look; a contact is told by the rank that owns its sphere, which alone knows its
// memory.
#pragma once

#include <mpi.h>

#include <utility>
#include <vector>

#include "contact/contact_step_bound.h"
#include "fixes/engine/bodies.h"
#include "math/types.h"

namespace LAMMPS_NS {
class Domain;
}  // namespace LAMMPS_NS

namespace muckpile {

/// Of one body, with another of this mass, or infinity [kg].
struct BodyContact {
  ContactResistance resistance{};
  Vec3 normal = Vec3::Zero(), point = Vec3::Zero();  ///< where it acts [m]
  double other_mass = 0.0;
};

class SharedStepBound {
 public:
  /// `bound` of the bodies that this rank moves.
  SharedStepBound(LAMMPS_NS::FixMultisphere& bodies, LAMMPS_NS::Domain& domain,
                  ContactStepBound bound)
      : map_(bodies), bodies_(bodies), domain_(domain), bound_(std::move(bound)) {}

  /// Of a body by its tag; below 0: of none, and left out.
  void add(int body_tag, const BodyContact& contact);
  /// With what other ranks have to tell of the bodies that this rank moves. Collective.
  [[nodiscard]] const ContactStepBound& of_all_ranks(MPI_Comm world);

 private:
  void add_here(int body, const BodyContact& contact);

  LAMMPS_NS::FixMultisphere& map_;
  engine::Bodies bodies_;
  LAMMPS_NS::Domain& domain_;
  ContactStepBound bound_;
  std::vector<double> for_others_;
};

}  // namespace muckpile
