// SPDX-License-Identifier: GPL-2.0-or-later
// What the passes ask of a facet's joint law, one facet at a time: closure, energy, friction,
// contact, apertures, memory. of_bonded() and of_contact() alone choose the form that a law has.
// Scope: the pose of the blocks. Where a law is grouped, whole groups of facets go by their
// stiffness instead (TractionPass, BrokenContact, DilatationPass). SI units; per area unless said.
#pragma once

#include <optional>

#include "bond/law/joint_in_rock.h"
#include "bond/law/plane_contact.h"
#include "bond/network/facet_kinematics.h"
#include "bond/network/joint_books.h"

namespace muckpile {

[[nodiscard]] SeriesPoints series_points(const FacetKinematics& facets, std::size_t f);
/// `fade`: how far the faces match [-].
[[nodiscard]] SeriesContact series_contact(const FacetKinematics& facets, std::size_t f,
                                           double fade);

/// use(points that hold): LinearPoints or SeriesPoints.
template <class Use>
auto of_bonded(const FacetKinematics& facets, std::size_t f, const Use& use) {
  if (!facets.tables.joint(f).grouped()) return use(series_points(facets, f));
  return use(LinearPoints{facets.tables.bond(f)});
}
/// use(points that have broken): LinearContact, whose walls may crush, or SeriesContact.
template <class Use>
auto of_contact(const FacetKinematics& facets, std::size_t f, const ContactConstants& contact,
                double fade, const Use& use) {
  if (!facets.tables.joint(f).grouped()) return use(series_contact(facets, f, fade));
  const double closed = contact.closure.normal;
  if (!facets.tables.laws().crushes()) return use(LinearContact<Lanes>{fade * closed});
  return use(CrushingContact<Lanes>(fade, closed, facets.tables.wall_strength(f)));
}

// Points that hold.
/// Stored with those elastic jumps, twice [J/m2].
[[nodiscard]] Lanes bonded_energy(const FacetKinematics& facets, std::size_t f,
                                  const LaneVec& normal, const LaneVec& jump);
/// For small motions along the normal.
[[nodiscard]] StiffestNormal stiffest_normal(const FacetKinematics& facets, std::size_t f,
                                             bool bonded);

// Points that have broken.
[[nodiscard]] SlipFriction<Lanes, const JointLaw&> friction_of(const FacetKinematics& facets,
                                                               std::size_t f);
/// Tractions over a step dt [s].
[[nodiscard]] PlanePull<Lanes> contact_pull(const FacetKinematics& facets, std::size_t f,
                                            const ContactConstants& contact,
                                            const PlanePoint<Lanes>& at, double dt);
/// By how far points of faces that match are open where they carry that normal traction [m].
[[nodiscard]] Lanes contact_gap(const FacetKinematics& facets, std::size_t f,
                                const ContactConstants& contact, double traction);
/// Stored by points that are closed, 0 by others, twice [J/m2]; `spring`: the jumps from where they
/// carry nothing [m].
[[nodiscard]] Lanes contact_energy_of(const FacetKinematics& facets, std::size_t f,
                                      const ContactConstants& contact, double fade,
                                      const LaneVec& normal, const LaneVec& spring);
/// Jumps from where contact points carry nothing [m].
[[nodiscard]] LaneVec contact_spring(const FacetKinematics& facets, std::size_t f,
                                     const FacetMotion& motion);
/// What gas finds of the broken points, in the mean; none where the law knows no apertures.
struct BrokenApertures : JointApertures {
  double at_break;  ///< mechanical one just after each point broke [m]
};
[[nodiscard]] std::optional<BrokenApertures> mean_apertures(const FacetKinematics& facets,
                                                            std::size_t f);

// What points remember; of a grouped law nothing.
/// Of a point that has just broken and left the dilatations, closed under that normal traction, or
/// slips in them with that elastic jump: the closure that gas finds first.
void remember_break(const FacetKinematics& facets, FacetHistory& history, std::size_t f,
                    std::size_t p, const Vec3& normal, const Vec3& elastic, double traction,
                    bool slips);
/// Of points that slip, at that speed [m/s] for that time [s].
void remember_slip(const FacetTables& tables, FacetHistory& history, std::size_t f,
                   const LaneMask& slips, const LaneVec& speed, double time);
/// The largest closure of each point; what the joint takes for good as that grows is booked as
/// friction, of its asperities.
void remember_closure(const FacetKinematics& facets, FacetHistory& history, JointLosses& losses,
                      std::size_t f, const FacetMotion& motion, const ContactConstants& contact);

}  // namespace muckpile
