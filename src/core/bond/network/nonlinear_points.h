// SPDX-License-Identifier: GPL-2.0-or-later
// Points of facets whose joint class has a nonlinear law (law/joint_law.h), and what a point of any
// law is asked one by one: friction, energy, contact, largest stiffness.
// Scope: one facet at a time, in the pose of its blocks. Callers tell the laws apart where the
// linear one goes by groups of facets (TractionPass, BrokenContact, DilatationPass) or is worked
// out in a form of its own (BondedPoints, FacetBreaking, the energies). SI units; per area unless
// said.
#pragma once

#include <optional>

#include "bond/law/plane_contact.h"
#include "bond/network/facet_breaking.h"
#include "bond/network/facet_kinematics.h"

namespace muckpile {

// Of a facet with a nonlinear law.
[[nodiscard]] NonlinearClosure nonlinear_closure(const FacetKinematics& facets, std::size_t f);
/// Of the jump that a breaking point takes out of the dilatations, what counts there [m]; `kept`:
/// the elastic jump that it keeps if it stays there.
[[nodiscard]] Vec3 nonlinear_strain_lost(const FacetKinematics& facets, std::size_t f,
                                         const PointBreak& broken, const Vec3& kept, bool stays);
/// Of the closed broken points [J].
[[nodiscard]] double nonlinear_contact_energy(const FacetKinematics& facets, std::size_t f,
                                              const FacetMotion& motion,
                                              const ContactConstants& contact);
/// Tractions of broken points over a step dt [s].
[[nodiscard]] PlanePull<Lanes> nonlinear_pull(const FacetKinematics& facets, std::size_t f,
                                              const ContactConstants& contact,
                                              const PlanePoint<Lanes>& at, double dt);
/// The same; remembers their slip.
[[nodiscard]] PlanePull<Lanes> nonlinear_plane_pull(const FacetKinematics& facets,
                                                    FacetHistory& history, std::size_t f,
                                                    const ContactConstants& contact,
                                                    const PlanePoint<Lanes>& at, double dt);
/// Of a point that has just broken and left the dilatations, closed under that normal traction, or
/// slips in them with that elastic jump: the closure that gas finds first.
void remember_break(const FacetKinematics& facets, FacetHistory& history, std::size_t f,
                    std::size_t p, const Vec3& normal, const Vec3& elastic, double traction,
                    bool slips);
void remember_slip(FacetHistory& history, std::size_t f, const LaneMask& slips, const Lanes& path);
/// The largest closure of each point; what the joint takes for good as that grows is booked as
/// friction, of its asperities.
void remember_joint(const FacetKinematics& facets, FacetHistory& history, JointLosses& losses,
                    std::size_t f, const FacetMotion& motion, const ContactConstants& contact);

// Of a facet of any law.
/// What gas finds of the broken points, in the mean; none where the law knows no apertures.
struct BrokenApertures : JointApertures {
  double at_break;  ///< mechanical one just after each point broke [m]
};
[[nodiscard]] std::optional<BrokenApertures> mean_apertures(const FacetKinematics& facets,
                                                           std::size_t f);
/// What friction can hold at the points under a normal traction, not positive, at that speed of
/// slip, squared [Pa], [m2/s2].
[[nodiscard]] Lanes friction_limit(const FacetKinematics& facets, std::size_t f,
                                   const Lanes& normal, const Lanes& speed_squared);
/// Stored by a point that holds with that elastic jump, twice [J/m2].
[[nodiscard]] double bonded_energy_at(const FacetKinematics& facets, std::size_t f, std::size_t p,
                                      const Vec3& normal, const Vec3& jump);
/// By how far a contact point is open where it carries that normal traction [m].
[[nodiscard]] double contact_gap(const FacetKinematics& facets, std::size_t f, std::size_t p,
                                 const ContactConstants& contact, double traction);
/// What it then stores, with that shear traction [Pa], twice [J/m2].
[[nodiscard]] double contact_energy_at(const FacetKinematics& facets, std::size_t f, std::size_t p,
                                       const ContactConstants& contact, double traction,
                                       const Vec3& shear);
/// A point for small motions along the normal, at the closure at which it is stiffest.
struct StiffestNormal {
  double stiffness;  ///< [Pa/m]
  double share;      ///< of the motion that strains rock, over FacetTables::rock_share() [-]
};
[[nodiscard]] StiffestNormal stiffest_normal(const FacetKinematics& facets, std::size_t f,
                                             bool bonded);

}  // namespace muckpile
