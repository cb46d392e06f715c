// SPDX-License-Identifier: GPL-2.0-or-later
// Broken points of one facet: plane contact, fading, retiring.
// Scope: see the header.
#include "bond/network/broken_contact.h"

#include <cmath>

#include "bond/network/facet_energy.h"
#include "bond/network/joint_points.h"
#include "bond/network/softening_points.h"

namespace muckpile {
namespace {

PlanePoint<Lanes> contact_points(const FacetKinematics& facets, std::size_t f,
                                 const FacetMotion& motion, const LaneVec& rate) {
  const FacetTraces& traces = facets.history.traces(f);
  return {LaneVec(motion.normal), contact_spring(facets, f, motion), rate,
          facets.history.bonded_points(f) == 0 ? is_point() : where_contact(traces),
          LaneMask(traces.open)};
}

}  // namespace

/// No time passes, and nothing moves: dashpots carry nothing then.
LaneVec contact_tractions(const FacetKinematics& facets, std::size_t f, const FacetMotion& motion) {
  const ContactConstants contact = facets.tables.contact(f);
  const PlanePoint<Lanes> at = contact_points(facets, f, motion, LaneVec());
  const PlanePull<Lanes> pull = contact_pull(facets, f, contact, at, 0.0);
  return choose(at.broken, Lanes(1.0), 0.0) * pull.traction;
}

FacetParting<double> parting_of(const FacetMotion& motion, const ContactConstants& contact) {
  const double opened = dot(LaneVec(motion.normal), motion.apart)[0];
  return {opened, across_squared<double>(dot(motion.apart, motion.apart)[0], opened),
          contact.radius_squared, motion.turn()};
}

void BrokenContact::add_tractions(std::size_t f, const FacetMotion& motion,
                                  const ContactConstants& contact, FacetPull& pull) {
  ContactRows& contacts = history_.contacts();
  const double fade = contacts.fade(f);
  const Mat3 axes = motion.axes();
  const PlanePoint<Lanes> at = contact_points(facets_, f, motion, pull.rate);
  const LaneMask broken = at.broken;
  const PlanePull<Lanes> at_points = contact_pull(facets_, f, contact, at, dt_);
  const LaneMask slips = broken && at_points.yields && dot(at.normal, at_points.traction) < 0.0;
  remember_slip(facets_.tables, history_, f, slips, at.rate - dot(at.normal, at.rate) * at.normal,
                dt_);
  history_.set_open(f, false);
  pull.traction = choose(broken, at_points.traction, pull.traction);
  const double booked = contact.weight * contact.point_area;
  books_.losses.damping += booked * dt_ * sum(at_points.damped);
  books_.losses.friction += 0.5 * booked * fade * contact.shear * sum(at_points.rubbed);
  books_.losses.crush(0.5 * booked * fade * contact.closure.normal * sum(at_points.crushed));
  if (none_of(at_points.yields)) return;
  const LaneVec offset = rotated_back(axes, pull.jump - at_points.elastic);
  for (std::size_t p = 0; p < kFacetPoints; ++p)
    if (at_points.yields[p]) contacts.set_offset(f, p, offset.at(static_cast<int>(p)));
}

bool BrokenContact::remains(std::size_t f, const FacetMotion& motion,
                            const ContactConstants& contact) {
  const FacetParting<double> parting = parting_of(motion, contact);
  if (parting.begins_to_fade()) {
    fade(f, motion,
         matching_faces(std::sqrt(parting.slid / parting.radius_squared),
                        std::sqrt(parting.turn.squared())));
  }
  const double closes_at = history_.contacts().closes_at(f);
  const bool away = history_.contacts().fade(f) == 0.0 || parting.gone(closes_at);
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
  if (!parting.surely_open(closes_at)) return true;
  history_.set_open(f, true);
  return false;
}

void BrokenContact::retire(std::size_t f) {
  if (history_.state(f) == FacetState::cracked) books_.newly_let_go = true;
  // Of a facet that tilts a corner may still be pressed.
  books_.losses.friction +=
      facets_.tables.weight(f) * contact_energy(facets_, f, facets_.motion(f));
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
