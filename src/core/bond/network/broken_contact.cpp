// SPDX-License-Identifier: GPL-2.0-or-later
// Broken points of one facet: plane contact, fading, retiring.
// Scope: see the header.
#include "bond/network/broken_contact.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "bond/law/plane_contact.h"
#include "bond/network/facet_energy.h"
#include "bond/network/nonlinear_points.h"

namespace muckpile {
namespace {

/// Square of the mean slide of a facet's sides [m2].
double slid_squared(const LaneVec& apart, const Vec3& normal) {
  const double opened = dot(LaneVec(normal), apart)[0];
  return std::max(dot(apart, apart)[0] - opened * opened, 0.0);
}

PlanePoint<Lanes> contact_points(const FacetKinematics& facets, std::size_t f,
                                 const FacetMotion& motion, const LaneVec& rate) {
  const FacetTraces& traces = facets.history.traces(f);
  const LaneVec offset = lanes_of(facets.history.contacts().get(f).offset);
  return {LaneVec(motion.normal), motion.jump() - rotated(motion.axes(), offset), rate,
          facets.history.bonded_points(f) == 0 ? is_point() : where_contact(traces),
          LaneMask(traces.open)};
}

/// With the linear law.
PlanePull<Lanes> linear_pull(const FacetKinematics& facets, std::size_t f,
                             const ContactConstants& contact, const PlanePoint<Lanes>& at,
                             double dt) {
  const FacetTables& tables = facets.tables;
  const double fade = facets.history.contacts().fade(f);
  const auto pull = [&](const auto& closure) {
    return plane_pull(
        PlaneContact<Lanes, std::remove_cvref_t<decltype(closure)>>{
            closure, fade * contact.shear, fade * tables.contact_damping(f),
            tables.laws().friction(Lanes(tables.residual_friction(f)))},
        at, dt);
  };
  const LinearContact<Lanes> closure{fade * contact.closure.normal};
  if (!tables.laws().crushes()) return pull(closure);
  return pull(CrushingContact<Lanes>{closure, -tables.wall_strength(f) / contact.closure.normal});
}

}  // namespace

/// No time passes, and nothing moves: dashpots carry nothing then.
LaneVec contact_tractions(const FacetKinematics& facets, std::size_t f, const FacetMotion& motion) {
  const ContactConstants contact = facets.tables.contact(f);
  const PlanePoint<Lanes> at = contact_points(facets, f, motion, LaneVec());
  const PlanePull<Lanes> pull = facets.tables.nonlinear_law(f) == nullptr
                                    ? linear_pull(facets, f, contact, at, 0.0)
                                    : nonlinear_pull(facets, f, contact, at, 0.0);
  return choose(at.broken, Lanes(1.0), 0.0) * pull.traction;
}

bool slid_away(const FacetMotion& motion, const ContactConstants& contact) {
  return slid_squared(motion.apart, motion.normal) >
         kSlideStart * kSlideStart * contact.radius_squared;
}

void BrokenContact::add_tractions(std::size_t f, const FacetMotion& motion,
                                  const ContactConstants& contact, FacetPull& pull) {
  ContactRows& contacts = history_.contacts();
  const double fade = contacts.fade(f);
  const Mat3 axes = motion.axes();
  const PlanePoint<Lanes> at = contact_points(facets_, f, motion, pull.rate);
  const LaneMask broken = at.broken;
  const PlanePull<Lanes> at_points =
      facets_.tables.nonlinear_law(f) == nullptr
          ? linear_pull(facets_, f, contact, at, dt_)
          : nonlinear_plane_pull(facets_, history_, f, contact, at, dt_);
  history_.set_open(f, false);
  pull.traction = choose(broken, at_points.traction, pull.traction);
  const double booked = contact.weight * contact.point_area;
  books_.losses.damping += booked * dt_ * sum(at_points.damped);
  books_.losses.friction += 0.5 * booked * fade * contact.shear * sum(at_points.rubbed);
  books_.losses.crush(0.5 * booked * fade * contact.closure.normal * sum(at_points.crushed));
  if (none_of(at_points.rests)) return;
  const LaneVec offset = rotated_back(axes, pull.jump - at_points.resting);
  for (std::size_t p = 0; p < kFacetPoints; ++p)
    if (at_points.rests[p]) contacts.set_offset(f, p, offset.at(static_cast<int>(p)));
}

bool BrokenContact::remains(std::size_t f, const FacetMotion& motion,
                            const ContactConstants& contact) {
  const double opened = dot(LaneVec(motion.normal), motion.apart)[0];
  const Lanes squares = dot(motion.apart, motion.apart);  // of the jump, of how half axes differ
  const double slid = slid_squared(motion.apart, motion.normal);
  if (slid > kSlideStart * kSlideStart * contact.radius_squared || motion.turned(kTurnStart)) {
    fade(f, motion,
         matching_faces(std::sqrt(slid / contact.radius_squared),
                        std::sqrt(motion.turned_squared())));
  }
  const bool away = history_.contacts().fade(f) == 0.0 || contact.longer(opened, kOpened);
  if (facets_.tables.laws().softens() && history_.softens(f)) {
    if (!away) return true;
    // Faces that no longer match hold nothing.
    books_.losses.fracture += contact.weight * cohesion_energy(facets_, f, motion);
    if (facets_.tables.is_joint(f)) history_.stop_softening(f);
  }
  if (away) {
    retire(f);
    return false;
  }
  if (!contact.longer(opened, kSurelyOpen)) return true;
  const Lanes lengths = sqrt(squares);
  const double radius = contact.radius();
  const double tilted = std::sqrt(slid * motion.turned_squared()) + kSurelyOpen * radius;
  const double gap = opened - lengths[1] - lengths[2] - tilted;
  if (gap <= 0.0) return true;
  history_.set_open(f, true);
  return false;
}

void BrokenContact::retire(std::size_t f) {
  if (history_.state(f) == FacetState::cracked) books_.newly_let_go = true;
  history_.retire(f);
  schedule_.note_change();
}

/// A facet whose faces match less than before gives up spring energy, which is booked as friction.
void BrokenContact::fade(std::size_t f, const FacetMotion& motion, double matching) {
  const double before = history_.contacts().fade(f);
  if (matching >= before) return;
  books_.losses.friction +=
      facets_.tables.weight(f) * (1.0 - matching / before) * contact_energy(facets_, f, motion);
  if (history_.state(f) == FacetState::cracked) books_.newly_let_go = true;
  history_.fade(f, matching);
}

}  // namespace muckpile
