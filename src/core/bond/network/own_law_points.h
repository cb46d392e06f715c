// SPDX-License-Identifier: GPL-2.0-or-later
// Points of facets whose joint class has a law of its own (law/joint_law.h), and what a point of
// any law is asked one by one: friction, contact, tangent.
// Scope: one facet at a time, in the pose of its blocks; the only other places that tell the laws
// apart are the lists of lanes that go by groups. SI units; per area unless said.
#pragma once

#include "bond/law/plane_contact.h"
#include "bond/network/facet_breaking.h"
#include "bond/network/facet_kinematics.h"

namespace muckpile {

// Of a facet with a law of its own.
[[nodiscard]] OwnClosure own_closure(const FacetKinematics& facets, std::size_t f);
[[nodiscard]] OwnContact own_contact(const FacetKinematics& facets, std::size_t f, double fade);
/// Of the jump that a breaking point takes out of the dilatations, what counts there [m]; `kept`:
/// the elastic jump that it keeps if it stays there.
[[nodiscard]] Vec3 own_strain_lost(const FacetKinematics& facets, std::size_t f,
                                   const PointBreak& broken, const Vec3& kept, bool stays);
/// Of the breaking point if it held with that jump, twice [J/m2].
[[nodiscard]] double own_twice_energy(const FacetKinematics& facets, std::size_t f,
                                      const PointBreak& broken, const Vec3& jump);
/// Of all points that hold, twice [J/m2].
[[nodiscard]] double own_bonded_energy(const FacetKinematics& facets, std::size_t f,
                                       const FacetMotion& motion);
/// Of the closed broken points [J].
[[nodiscard]] double own_contact_energy(const FacetKinematics& facets, std::size_t f,
                                        const FacetMotion& motion, const ContactConstants& contact);
/// Tractions of broken points over a step dt [s]; remembers their slip.
[[nodiscard]] PlanePull<Lanes> own_plane_pull(const FacetKinematics& facets, FacetHistory& history,
                                              std::size_t f, const ContactConstants& contact,
                                              const PlanePoint<Lanes>& at, double dt);
/// What gas finds of the broken points, in the mean [m].
[[nodiscard]] double own_aperture(const FacetKinematics& facets, std::size_t f);
void remember_slip(FacetHistory& history, std::size_t f, const LaneMask& slips, const Lanes& path);
/// The largest closure of each point; what the joint takes for good as that grows is booked as
/// friction, of its asperities.
void remember_joint(const FacetKinematics& facets, FacetHistory& history, JointLosses& losses,
                    std::size_t f, const FacetMotion& motion, const ContactConstants& contact);

// Of a facet of any law.
/// What friction can hold at the points under a normal traction, not positive, at that speed of
/// slip, squared [Pa], [m2/s2].
[[nodiscard]] Lanes friction_limit(const FacetKinematics& facets, std::size_t f,
                                   const Lanes& normal, const Lanes& speed_squared);
/// By how far a contact point is open where it carries that normal traction [m].
[[nodiscard]] double contact_gap(const FacetKinematics& facets, std::size_t f, std::size_t p,
                                 const ContactConstants& contact, double traction);
/// What it then stores, twice [J/m2].
[[nodiscard]] double contact_energy_at(const FacetKinematics& facets, std::size_t f, std::size_t p,
                                       const ContactConstants& contact, double traction);
/// Of a point for small motions along the normal.
struct NormalTangent {
  double stiffness;  ///< [Pa/m]
  double share;      ///< of the motion that strains rock, over FacetTables::rock_share() [-]
};
[[nodiscard]] NormalTangent normal_tangent(const FacetKinematics& facets, std::size_t f,
                                           std::size_t p, const FacetMotion& motion, bool bonded);

}  // namespace muckpile
