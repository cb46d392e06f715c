// SPDX-License-Identifier: GPL-2.0-or-later
// Broken points that soften: what points that have reached their strength still hold.
// Scope: a pass over one facet, only with fracture energies; the law is bond/law/cohesion.h. SI
// units.
#pragma once

#include "bond/network/facet_kinematics.h"
#include "bond/network/facet_pull.h"
#include "bond/network/joint_books.h"

namespace muckpile {

/// Adds what broken points of facet f still hold to `pull` over a step dt [s]. The work that
/// leapfrog takes, less what is stored, is booked as fracture.
void add_cohesion(const FacetKinematics& facets, FacetHistory& history, JointLosses& losses,
                  std::size_t f, const FacetMotion& motion, FacetPull& pull, double dt);

/// Of all points; 0 at those that hold nothing.
[[nodiscard]] CohesionOf<Lanes> cohesion_at_points(const FacetHistory& history, std::size_t f);
/// Stored in points that soften, of the whole facet [J].
[[nodiscard]] double cohesion_energy(const FacetKinematics& facets, std::size_t f,
                                     const FacetMotion& motion);
/// What the points of facet f hold in this pose, on block i; 0 at those that do not soften [Pa].
[[nodiscard]] LaneVec cohesion_tractions(const FacetKinematics& facets, std::size_t f,
                                         const FacetMotion& motion);

}  // namespace muckpile
