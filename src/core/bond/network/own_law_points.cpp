// SPDX-License-Identifier: GPL-2.0-or-later
// Points of facets with a law of their own, and what a point of any law is asked one by one.
// Scope: see the header.
#include "bond/network/own_law_points.h"

#include <array>
#include <cmath>

namespace muckpile {
namespace {

JointHistoryOf<Lanes> joint_history(const FacetHistory& history, std::size_t f) {
  const auto of = [&](double JointHistory::*number) {
    return Lanes([&](auto lane) {
      return lane < kFacetPoints ? history.joint(f, lane % kFacetPoints).*number : 0.0;
    });
  };
  return {of(&JointHistory::closure), of(&JointHistory::slip)};
}

/// Jumps of contact points from where they carry nothing [m].
LaneVec contact_spring(const FacetKinematics& facets, std::size_t f, const FacetMotion& motion) {
  return motion.jump() - rotated(motion.axes(), lanes_of(facets.history.contacts().get(f).offset));
}

/// Closures of the joint at points that are in the dilatations [m].
Lanes bonded_closure(const FacetKinematics& facets, std::size_t f, const FacetMotion& motion) {
  const Lanes along = dot(LaneVec(motion.normal), facets.elastic_jump(f, motion));
  return own_closure(facets, f).parts(along).joint.closure;
}

}  // namespace

OwnClosure own_closure(const FacetKinematics& facets, std::size_t f) {
  const FacetTables& tables = facets.tables;
  const double uniaxial = tables.uniaxial_stiffness(f);
  return {tables.own_law(f), tables.bond(f).shear, tables.laws().shear_over_p_wave() * uniaxial,
          uniaxial,          tables.rock_share(f), joint_history(facets.history, f)};
}

OwnContact own_contact(const FacetKinematics& facets, std::size_t f, double fade) {
  return {facets.tables.own_law(f), fade, facets.tables.uniaxial_stiffness(f),
          joint_history(facets.history, f).closure};
}

Vec3 own_bonded_jump(const FacetKinematics& facets, std::size_t f, const FacetMotion& motion) {
  const LaneMask bonded = is_point() && !where_contact(facets.history.traces(f));
  const LaneVec strained =
      own_closure(facets, f).strained(LaneVec(motion.normal), facets.elastic_jump(f, motion));
  return sum(choose(bonded, Lanes(1.0 / kFacetPoints), 0.0) * strained);
}

Vec3 own_strain_lost(const FacetKinematics& facets, std::size_t f, const PointBreak& broken,
                     const Vec3& kept, bool stays) {
  const OwnClosure own = own_closure(facets, f);
  const LaneVec normal(broken.normal);
  const Vec3 before = own.strained(normal, LaneVec(broken.elastic)).at(broken.point);
  return stays ? Vec3(before - own.strained(normal, LaneVec(kept)).at(broken.point)) : before;
}

double own_twice_energy(const FacetKinematics& facets, std::size_t f, const PointBreak& broken,
                        const Vec3& jump) {
  const Lanes stored = own_closure(facets, f).twice_energy(LaneVec(broken.normal), LaneVec(jump));
  return stored[static_cast<std::size_t>(broken.point)];
}

double own_bonded_energy(const FacetKinematics& facets, std::size_t f, const FacetMotion& motion) {
  const LaneMask bonded = is_point() && !where_contact(facets.history.traces(f));
  const Lanes stored =
      own_closure(facets, f).twice_energy(LaneVec(motion.normal), facets.elastic_jump(f, motion));
  return sum(choose(bonded, stored, 0.0));
}

double own_contact_energy(const FacetKinematics& facets, std::size_t f, const FacetMotion& motion,
                          const ContactConstants& contact) {
  const LaneMask points = is_point() && where_contact(facets.history.traces(f));
  if (none_of(points)) return 0.0;
  const OwnContact own = own_contact(facets, f, facets.history.contacts().fade(f));
  const LaneVec normal(motion.normal), spring = contact_spring(facets, f, motion);
  const Lanes gap = dot(normal, spring);
  const LaneVec sheared = spring - gap * normal;
  const Lanes stored = own.twice_energy(gap) + own.fade * contact.shear * dot(sheared, sheared);
  return 0.5 * contact.point_area * sum(choose(points && own.traction(gap) < 0.0, stored, 0.0));
}

PlanePull<Lanes> own_plane_pull(const FacetKinematics& facets, FacetHistory& history, std::size_t f,
                                const ContactConstants& contact, const PlanePoint<Lanes>& at,
                                double dt) {
  const JointLaws& laws = facets.tables.laws();
  const double fade = history.contacts().fade(f);
  const PlaneContact<Lanes, OwnContact, OwnFriction> law = {
      own_contact(facets, f, fade),
      fade * contact.shear,
      fade * laws.contact_damping(),
      {facets.tables.own_law(f), joint_history(history, f).slip, laws.slip_weakening()}};
  const PlanePull<Lanes> pull = plane_pull<Lanes>(law, at, dt);
  const Lanes rate = dot(at.normal, at.rate);
  const LaneVec slip = at.rate - rate * at.normal;
  const LaneMask slips = at.broken && pull.rests && dot(at.normal, pull.traction) < 0.0;
  remember_slip(history, f, slips, dt * sqrt(dot(slip, slip)));
  return pull;
}

double own_aperture(const FacetKinematics& facets, std::size_t f) {
  const FacetMotion motion = facets.motion(f);
  const FacetTraces& traces = facets.history.traces(f);
  const Lanes bonded = bonded_closure(facets, f, motion);
  const Lanes gap = dot(LaneVec(motion.normal), contact_spring(facets, f, motion));
  const Lanes apart = own_contact(facets, f, 1.0).closure(gap);
  double apertures = 0.0;
  for (std::size_t p = 0; p < kFacetPoints; ++p)
    if (traces.broken[p])
      apertures +=
          facets.tables.own_law(f)->hydraulic_aperture(traces.slipping[p] ? bonded[p] : apart[p]);
  return traces.broken.any() ? apertures / traces.broken.count() : 0.0;
}

void remember_slip(FacetHistory& history, std::size_t f, const LaneMask& slips, const Lanes& path) {
  for (std::size_t p = 0; p < kFacetPoints; ++p)
    if (slips[p]) history.joint_of_point(f, p).slip += path[p];
}

void remember_joint(const FacetKinematics& facets, FacetHistory& history, JointLosses& losses,
                    std::size_t f, const FacetMotion& motion, const ContactConstants& contact) {
  const double fade = history.bonded_points(f) == kFacetPoints ? 1.0 : history.contacts().fade(f);
  const LaneMask apart = where_contact(history.traces(f));
  const Lanes before = joint_history(history, f).closure;
  Lanes closure = bonded_closure(facets, f, motion);
  if (any_of(apart)) {
    const Lanes gap = dot(LaneVec(motion.normal), contact_spring(facets, f, motion));
    closure = choose(apart, own_contact(facets, f, fade).closure(gap), closure);
  }
  const LaneMask more = is_point() && closure > before;
  if (none_of(more)) return;
  const JointLaw& law = *facets.tables.own_law(f);
  const Lanes taken = law.taken(max(closure, before)) - law.taken(before);
  losses.friction += contact.weight * contact.point_area *
                     sum(choose(more, choose(apart, Lanes(fade), 1.0) * taken, 0.0));
  for (std::size_t p = 0; p < kFacetPoints; ++p)
    if (more[p]) history.joint_of_point(f, p).closure = closure[p];
}

Lanes friction_limit(const FacetKinematics& facets, std::size_t f, const Lanes& normal,
                     const Lanes& speed_squared) {
  const FacetTables& tables = facets.tables;
  const SlipWeakening& weakening = tables.laws().slip_weakening();
  if (tables.own_law(f) == nullptr)
    return SlipFriction<Lanes>{tables.residual_friction(f), weakening}.limit(normal, speed_squared);
  return OwnFriction{tables.own_law(f), joint_history(facets.history, f).slip, weakening}.limit(
      normal, speed_squared);
}

double contact_gap(const FacetKinematics& facets, std::size_t f, std::size_t p,
                   const ContactConstants& contact, double traction) {
  return facets.tables.own_law(f) == nullptr ? contact.closure.gap(traction)
                                             : own_contact(facets, f, 1.0).gap(traction)[p];
}

double contact_energy_at(const FacetKinematics& facets, std::size_t f, std::size_t p,
                         const ContactConstants& contact, double traction) {
  if (facets.tables.own_law(f) == nullptr) return contact.closure.twice_energy_of(traction);
  const OwnContact own = own_contact(facets, f, 1.0);
  return own.twice_energy(own.gap(traction))[p];
}

/// A contact of a law of its own may become as stiff as the rock.
NormalTangent normal_tangent(const FacetKinematics& facets, std::size_t f, std::size_t p,
                             const FacetMotion& motion, bool bonded) {
  const FacetTables& tables = facets.tables;
  if (tables.own_law(f) == nullptr)
    return {bonded ? tables.bond(f).normal() : tables.contact(f).closure.normal, 1.0};
  const OwnClosure own = own_closure(facets, f);
  if (!bonded) return {own.uniaxial, 1.0};
  const Lanes along = dot(LaneVec(motion.normal), facets.elastic_jump(f, motion));
  return {own.tangent(along)[p], own.parts(along).rock_rate[p] / own.rock_share};
}

}  // namespace muckpile
