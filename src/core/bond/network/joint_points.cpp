// SPDX-License-Identifier: GPL-2.0-or-later
// What the passes ask of a facet's joint law, one facet at a time.
// Scope: see the header.
#include "bond/network/joint_points.h"

#include <array>
#include <cmath>

namespace muckpile {
namespace {

JointHistoryOf<Lanes> joint_history(const FacetHistory& history, std::size_t f) {
  if (!history.has_extra(f)) return {};
  const auto of = [&](double JointHistory::*number) {
    return Lanes([&](auto lane) {
      return lane < kFacetPoints ? history.joint(f, lane % kFacetPoints).*number : 0.0;
    });
  };
  return {of(&JointHistory::closure), of(&JointHistory::slip)};
}

/// Closures of the joint at points that are in the dilatations [m].
Lanes bonded_closure(const FacetKinematics& facets, std::size_t f, const FacetMotion& motion) {
  const Lanes along = dot(LaneVec(motion.normal), facets.elastic_jump(f, motion));
  return series_points(facets, f).closure(along);
}

}  // namespace

SeriesPoints series_points(const FacetKinematics& facets, std::size_t f) {
  const FacetTables& tables = facets.tables;
  const double uniaxial = tables.uniaxial_stiffness(f);
  return {&tables.joint(f), tables.bond(f).shear, tables.shear_over_p_wave(f) * uniaxial,
          uniaxial,         tables.rock_share(f), joint_history(facets.history, f)};
}

SeriesContact series_contact(const FacetKinematics& facets, std::size_t f, double fade) {
  return {&facets.tables.joint(f), fade, facets.tables.uniaxial_stiffness(f),
          joint_history(facets.history, f).closure};
}

Lanes bonded_energy(const FacetKinematics& facets, std::size_t f, const LaneVec& normal,
                    const LaneVec& jump) {
  return of_bonded(facets, f,
                   [&](const auto& points) { return points.twice_energy(normal, jump); });
}

StiffestNormal stiffest_normal(const FacetKinematics& facets, std::size_t f, bool bonded) {
  if (bonded) return of_bonded(facets, f, [](const auto& points) { return points.stiffest(); });
  const Lanes stiffness = of_contact(facets, f, facets.tables.contact(f), 1.0,
                                     [](const auto& closure) { return closure.stiffest(); });
  return {stiffness[0], 1.0};
}

SlipFriction<Lanes, const JointLaw&> friction_of(const FacetKinematics& facets, std::size_t f) {
  return {facets.tables.joint(f), joint_history(facets.history, f).slip, facets.tables.grip(f),
          facets.tables.laws().slip_weakening()};
}

PlanePull<Lanes> contact_pull(const FacetKinematics& facets, std::size_t f,
                              const ContactConstants& contact, const PlanePoint<Lanes>& at,
                              double dt) {
  const double fade = facets.history.contacts().fade(f);
  return of_contact(facets, f, contact, fade, [&](const auto& closure) {
    const PlaneContact law{closure, Lanes(fade * contact.shear),
                           Lanes(fade * facets.tables.contact_damping(f)), friction_of(facets, f)};
    return plane_pull(law, at, dt);
  });
}

Lanes contact_gap(const FacetKinematics& facets, std::size_t f, const ContactConstants& contact,
                  double traction) {
  return of_contact(facets, f, contact, 1.0,
                    [&](const auto& closure) { return closure.gap(Lanes(traction)); });
}

Lanes contact_energy_of(const FacetKinematics& facets, std::size_t f,
                        const ContactConstants& contact, double fade, const LaneVec& normal,
                        const LaneVec& spring) {
  const Lanes gap = dot(normal, spring);
  const LaneVec sheared = spring - gap * normal;
  return of_contact(facets, f, contact, fade, [&](const auto& closure) {
    const Lanes stored = closure.twice_energy(gap) + fade * contact.shear * dot(sheared, sheared);
    return choose(closure.traction(gap) < 0.0, stored, 0.0);
  });
}

LaneVec contact_spring(const FacetKinematics& facets, std::size_t f, const FacetMotion& motion) {
  return motion.jump() - rotated(motion.axes(), lanes_of(facets.history.contacts().get(f).offset));
}

std::optional<BrokenApertures> mean_apertures(const FacetKinematics& facets, std::size_t f) {
  const JointLaw& law = facets.tables.joint(f);
  const FacetTraces& traces = facets.history.traces(f);
  if (!law.apertures(0.0) || !traces.broken.any()) return std::nullopt;
  const FacetMotion motion = facets.motion(f);
  const Lanes bonded = bonded_closure(facets, f, motion);
  const Lanes gap = dot(LaneVec(motion.normal), contact_spring(facets, f, motion));
  const Lanes apart = series_contact(facets, f, 1.0).closure(gap);
  BrokenApertures mean{{0.0, 0.0}, 0.0};
  for (std::size_t p = 0; p < kFacetPoints; ++p) {
    if (!traces.broken[p]) continue;
    const JointApertures at = law.apertures(traces.slipping[p] ? bonded[p] : apart[p]).value();
    mean.mechanical += at.mechanical / traces.broken.count();
    mean.hydraulic += at.hydraulic / traces.broken.count();
    mean.at_break +=
        law.apertures(facets.history.joint(f, p).broke_at)->mechanical / traces.broken.count();
  }
  return mean;
}

void remember_break(const FacetKinematics& facets, FacetHistory& history, std::size_t f,
                    std::size_t p, const Vec3& normal, const Vec3& elastic, double traction,
                    bool slips) {
  if (facets.tables.joint(f).grouped()) return;
  const SeriesContact contact = series_contact(facets, f, 1.0);
  const Lanes closure = slips ? series_points(facets, f).closure(Lanes(normal.dot(elastic)))
                              : contact.closure(contact.gap(traction));
  history.joint_of_point(f, p).broke_at = closure[p];
}

void remember_slip(const FacetTables& tables, FacetHistory& history, std::size_t f,
                   const LaneMask& slips, const LaneVec& speed, double time) {
  if (tables.joint(f).grouped()) return;
  const Lanes length = time * sqrt(dot(speed, speed));
  for (std::size_t p = 0; p < kFacetPoints; ++p)
    if (slips[p]) history.joint_of_point(f, p).slip += length[p];
}

void remember_closure(const FacetKinematics& facets, FacetHistory& history, JointLosses& losses,
                      std::size_t f, const FacetMotion& motion, const ContactConstants& contact) {
  const JointLaw& law = facets.tables.joint(f);
  if (law.grouped()) return;
  const double fade = history.bonded_points(f) == kFacetPoints ? 1.0 : history.contacts().fade(f);
  const LaneMask apart = where_contact(history.traces(f));
  const Lanes before = joint_history(history, f).closure;
  Lanes closure = bonded_closure(facets, f, motion);
  if (any_of(apart)) {
    const Lanes gap = dot(LaneVec(motion.normal), contact_spring(facets, f, motion));
    closure = choose(apart, series_contact(facets, f, fade).closure(gap), closure);
  }
  const LaneMask more = is_point() && closure > before;
  if (none_of(more)) return;
  const Lanes taken = law.taken(max(closure, before)) - law.taken(before);
  losses.friction += contact.weight * contact.point_area *
                     sum(choose(more, choose(apart, Lanes(fade), 1.0) * taken, 0.0));
  for (std::size_t p = 0; p < kFacetPoints; ++p)
    if (more[p]) history.joint_of_point(f, p).closure = closure[p];
}

}  // namespace muckpile
