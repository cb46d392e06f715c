// SPDX-License-Identifier: GPL-2.0-or-later
// Points of facets with a nonlinear joint law, and what a point of any law is asked one by one.
// Scope: see the header.
#include "bond/network/nonlinear_points.h"

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
  return nonlinear_closure(facets, f).parts(along).joint.closure;
}

NonlinearContact nonlinear_contact(const FacetKinematics& facets, std::size_t f, double fade) {
  return {facets.tables.nonlinear_law(f), fade, facets.tables.uniaxial_stiffness(f),
          joint_history(facets.history, f).closure};
}

NonlinearFriction nonlinear_friction(const FacetKinematics& facets, std::size_t f) {
  return {facets.tables.nonlinear_law(f), joint_history(facets.history, f).slip,
          facets.tables.laws().slip_weakening()};
}

}  // namespace

NonlinearClosure nonlinear_closure(const FacetKinematics& facets, std::size_t f) {
  const FacetTables& tables = facets.tables;
  const double uniaxial = tables.uniaxial_stiffness(f);
  return {tables.nonlinear_law(f),
          tables.bond(f).shear,
          tables.shear_over_p_wave(f) * uniaxial,
          uniaxial,
          tables.rock_share(f),
          joint_history(facets.history, f)};
}

Vec3 nonlinear_bonded_jump(const FacetKinematics& facets, std::size_t f,
                           const FacetMotion& motion) {
  const LaneMask bonded = is_point() && !where_contact(facets.history.traces(f));
  const LaneVec strained =
      nonlinear_closure(facets, f).strained(LaneVec(motion.normal), facets.elastic_jump(f, motion));
  return sum(choose(bonded, Lanes(1.0 / kFacetPoints), 0.0) * strained);
}

Vec3 nonlinear_strain_lost(const FacetKinematics& facets, std::size_t f, const PointBreak& broken,
                           const Vec3& kept, bool stays) {
  const NonlinearClosure closure = nonlinear_closure(facets, f);
  const LaneVec normal(broken.normal);
  const Vec3 before = closure.strained(normal, LaneVec(broken.elastic)).at(broken.point);
  return stays ? Vec3(before - closure.strained(normal, LaneVec(kept)).at(broken.point)) : before;
}

double nonlinear_contact_energy(const FacetKinematics& facets, std::size_t f,
                                const FacetMotion& motion, const ContactConstants& contact) {
  const LaneMask points = is_point() && where_contact(facets.history.traces(f));
  if (none_of(points)) return 0.0;
  const NonlinearContact joint = nonlinear_contact(facets, f, facets.history.contacts().fade(f));
  const LaneVec normal(motion.normal), spring = contact_spring(facets, f, motion);
  const Lanes gap = dot(normal, spring);
  const LaneVec sheared = spring - gap * normal;
  const Lanes stored = joint.twice_energy(gap) + joint.fade * contact.shear * dot(sheared, sheared);
  return 0.5 * contact.point_area * sum(choose(points && joint.traction(gap) < 0.0, stored, 0.0));
}

PlanePull<Lanes> nonlinear_pull(const FacetKinematics& facets, std::size_t f,
                                const ContactConstants& contact, const PlanePoint<Lanes>& at,
                                double dt) {
  const double fade = facets.history.contacts().fade(f);
  const PlaneContact<Lanes, NonlinearContact, NonlinearFriction> law = {
      nonlinear_contact(facets, f, fade), fade * contact.shear,
      fade * facets.tables.contact_damping(f), nonlinear_friction(facets, f)};
  return plane_pull<Lanes>(law, at, dt);
}

PlanePull<Lanes> nonlinear_plane_pull(const FacetKinematics& facets, FacetHistory& history,
                                      std::size_t f, const ContactConstants& contact,
                                      const PlanePoint<Lanes>& at, double dt) {
  const PlanePull<Lanes> pull = nonlinear_pull(facets, f, contact, at, dt);
  const Lanes rate = dot(at.normal, at.rate);
  const LaneVec slip = at.rate - rate * at.normal;
  const LaneMask slips = at.broken && pull.rests && dot(at.normal, pull.traction) < 0.0;
  remember_slip(history, f, slips, dt * sqrt(dot(slip, slip)));
  return pull;
}

void remember_break(const FacetKinematics& facets, FacetHistory& history, std::size_t f,
                    std::size_t p, const Vec3& normal, const Vec3& elastic, double traction,
                    bool slips) {
  const NonlinearContact contact = nonlinear_contact(facets, f, 1.0);
  const Lanes closure =
      slips ? nonlinear_closure(facets, f).parts(Lanes(normal.dot(elastic))).joint.closure
            : contact.closure(contact.gap(traction));
  history.joint_of_point(f, p).broke_at = closure[p];
}

std::optional<BrokenApertures> mean_apertures(const FacetKinematics& facets, std::size_t f) {
  const JointLaw* law = facets.tables.nonlinear_law(f);
  const FacetTraces& traces = facets.history.traces(f);
  if (law == nullptr || !traces.broken.any()) return std::nullopt;
  const FacetMotion motion = facets.motion(f);
  const Lanes bonded = bonded_closure(facets, f, motion);
  const Lanes gap = dot(LaneVec(motion.normal), contact_spring(facets, f, motion));
  const Lanes apart = nonlinear_contact(facets, f, 1.0).closure(gap);
  BrokenApertures mean{{0.0, 0.0}, 0.0};
  for (std::size_t p = 0; p < kFacetPoints; ++p) {
    if (!traces.broken[p]) continue;
    const std::optional<JointApertures> at =
        law->apertures(traces.slipping[p] ? bonded[p] : apart[p]);
    if (!at) return std::nullopt;
    mean.mechanical += at->mechanical / traces.broken.count();
    mean.hydraulic += at->hydraulic / traces.broken.count();
    mean.at_break += law->apertures(facets.history.joint(f, p).broke_at)->mechanical /
                     traces.broken.count();
  }
  return mean;
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
    closure = choose(apart, nonlinear_contact(facets, f, fade).closure(gap), closure);
  }
  const LaneMask more = is_point() && closure > before;
  if (none_of(more)) return;
  const JointLaw& law = *facets.tables.nonlinear_law(f);
  const Lanes taken = law.taken(max(closure, before)) - law.taken(before);
  losses.friction += contact.weight * contact.point_area *
                     sum(choose(more, choose(apart, Lanes(fade), 1.0) * taken, 0.0));
  for (std::size_t p = 0; p < kFacetPoints; ++p)
    if (more[p]) history.joint_of_point(f, p).closure = closure[p];
}

Lanes friction_limit(const FacetKinematics& facets, std::size_t f, const Lanes& normal,
                     const Lanes& speed_squared) {
  if (facets.tables.nonlinear_law(f) != nullptr)
    return nonlinear_friction(facets, f).limit(normal, speed_squared);
  return facets.tables.laws()
      .friction(Lanes(facets.tables.residual_friction(f)))
      .limit(normal, speed_squared);
}

double bonded_energy_at(const FacetKinematics& facets, std::size_t f, std::size_t p,
                        const Vec3& normal, const Vec3& jump) {
  if (facets.tables.nonlinear_law(f) == nullptr)
    return facets.tables.bond(f).twice_energy(jump.squaredNorm(), normal.dot(jump));
  return nonlinear_closure(facets, f).twice_energy(LaneVec(normal), LaneVec(jump))[p];
}

double contact_gap(const FacetKinematics& facets, std::size_t f, std::size_t p,
                   const ContactConstants& contact, double traction) {
  return facets.tables.nonlinear_law(f) == nullptr
             ? contact.closure.gap(traction)
             : nonlinear_contact(facets, f, 1.0).gap(traction)[p];
}

double contact_energy_at(const FacetKinematics& facets, std::size_t f, std::size_t p,
                         const ContactConstants& contact, double traction, const Vec3& shear) {
  const double sheared = contact.shear > 0.0 ? shear.squaredNorm() / contact.shear : 0.0;
  if (facets.tables.nonlinear_law(f) == nullptr)
    return contact.closure.twice_energy_of(traction) + sheared;
  const NonlinearContact joint = nonlinear_contact(facets, f, 1.0);
  return joint.twice_energy(joint.gap(traction))[p] + sheared;
}

StiffestNormal stiffest_normal(const FacetKinematics& facets, std::size_t f, bool bonded) {
  const FacetTables& tables = facets.tables;
  if (tables.nonlinear_law(f) == nullptr)
    return {bonded ? tables.bond(f).normal() : tables.contact(f).closure.normal, 1.0};
  const NonlinearClosure closure = nonlinear_closure(facets, f);
  if (!bonded) return {closure.uniaxial, 1.0};
  return {closure.stiffest(), 1.0 / closure.rock_share};
}

}  // namespace muckpile
