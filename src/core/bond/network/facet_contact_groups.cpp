// SPDX-License-Identifier: GPL-2.0-or-later
// The facet network where facets hold at no point: a group of them at once.
// Scope: as facet_contact.cpp works them out one by one; what happens once to a facet (fading,
// falling asleep, retiring) is done there.
#include <array>
#include <cmath>

#include "bond/law/plane_contact.h"
#include "bond/network/facet_wide.h"

namespace muckpile {

/// What the contact of a group's facets remembers, and what else its law needs.
struct FacetNetwork::WideContact {
  ContactGroup* memory;
  FacetRow<double> fresh{}, tan_residual{}, weight{}, rock_share{};
};

/// How far the two sides of each facet have parted.
struct FacetNetwork::WideParting {
  Wide opened;                // [m]
  Wide slid, radius_squared;  // squares; of the circle of equal area [m2]
  WideTurn turn;

  [[nodiscard]] unsigned begins_to_fade() const {
    return bits_of<Wide>(slid > kSlideStart * kSlideStart * radius_squared ||
                         turn.exceeds(kTurnStart));
  }
  [[nodiscard]] unsigned open_by(double radii) const {
    return bits_of<Wide>(opened > 0.0 && opened * opened > radii * radii * radius_squared);
  }
  /// Between the points that are closest, at least [m].
  [[nodiscard]] Wide gap() const {
    const Wide tilted = sqrt(slid * turn.squared()) + kSurelyOpen * sqrt(radius_squared);
    return opened - sqrt(turn.apart_1) - sqrt(turn.apart_2) - tilted;
  }
};

FacetNetwork::WideParting FacetNetwork::parting_of(const FacetGroup& group, const WidePose& pose) {
  const Wide opened = dot(pose.normal, pose.jump);
  return {opened, max(dot(pose.jump, pose.jump) - opened * opened, Wide(0.0)),
          M_1_PI * wide(group.area), turn_of(group, pose)};
}

/// Those of `working` that are broken at all points, awake and do not soften.
unsigned FacetNetwork::apart_lanes(const LaneSet& working) const {
  unsigned lanes = 0;
  each_lane(working.lanes, [&](std::size_t k) {
    const std::size_t f = working.group * kGroup + k;
    if (bonded_points_[f] == 0 && states_[f] != FacetState::retired && asleep_[f] <= calls_ &&
        !rare_.exists(f))
      lanes |= 1u << k;
  });
  return lanes;
}

FacetNetwork::WideContact FacetNetwork::remembered(std::size_t g, unsigned lanes) {
  WideContact contact{&contacts_.made(g, lanes)};
  each_lane(lanes, [&](std::size_t k) {
    const std::size_t f = g * kGroup + k;
    contact.fresh[k] = traces_[f].open ? 1.0 : 0.0;
    contact.weight[k] = facets_[f].weight;
    contact.rock_share[k] = rock_share(f);
    contact.tan_residual[k] = residual_friction(f);
  });
  return contact;
}

/// Lets facets fade whose sides match less than before.
void FacetNetwork::fade_group(std::size_t g, unsigned lanes, const WideParting& parting,
                              const ContactGroup& memory) {
  const Wide slid = sqrt(parting.slid / parting.radius_squared);
  const Wide turned = sqrt(parting.turn.squared());
  each_lane(lanes, [&](std::size_t k) {
    const double matching = matching_faces(slid[k], turned[k]);
    if (matching >= memory.fade[k]) return;
    const std::size_t f = g * kGroup + k;
    fade(f, motion_of(f), matching);
  });
}

/// Those of `lanes` that touch; the others fall asleep or retire.
unsigned FacetNetwork::closing(std::size_t g, unsigned lanes, const WidePose& pose,
                               const ContactGroup& memory, double dt) {
  const WideParting parting = parting_of(groups_[g], pose);
  const unsigned fading = lanes & parting.begins_to_fade();
  if (fading != 0) fade_group(g, fading, parting, memory);
  const unsigned gone =
      lanes & (parting.open_by(kOpened) | bits_of<Wide>(wide(memory.fade) == 0.0));
  each_lane(gone, [&](std::size_t k) { retire(g * kGroup + k); });
  unsigned open = lanes & ~gone & parting.open_by(kSurelyOpen);
  if (open == 0) return lanes & ~gone;
  const Wide gap = parting.gap(), radius = sqrt(parting.radius_squared);
  open &= bits_of<Wide>(gap > 0.0);
  each_lane(open, [&](std::size_t k) {
    traces_[g * kGroup + k].open = true;
    let_sleep(g * kGroup + k, gap[k], radius[k], dt);
  });
  return lanes & ~gone & ~open;
}

/// Forces of facets that touch, as add_contact() has them.
void FacetNetwork::touch_group(std::size_t g, unsigned lanes, const WidePose& pose,
                               const WideContact& contact, double dt, WideForces& forces) {
  const FacetGroup& group = groups_[g];
  const WideField rate = rate_of(group, pose), jump = jump_of(group, pose);
  const WideVec half_1 = pose.sum * wide(group.half_1), half_2 = pose.sum * wide(group.half_2);
  const WideField arm = {pose.arm(), Wide(0.5) * half_1, Wide(0.5) * half_2};
  const WideMat axes = axes_of(pose.normal, half_1);
  const ContactGroup& memory = *contact.memory;
  const Wide fade = choose(mask_of<Wide>(lanes), wide(memory.fade), 0.0),
             shear = fade * wide(group.shear);
  const LinearClosure<Wide> bonded{wide(group.shear), wide(group.normal_extra)};
  const Wide closed = bonded.contact(wide(contact.rock_share), shear_over_p_wave_);
  const PlaneContact<Wide> law = {{fade * closed},
                                  shear,
                                  fade * contact_damping_,
                                  {wide(contact.tan_residual), slip_weakening_}};
  const WideMask broken = fade > 0.0, fresh = wide(contact.fresh) > 0.0;
  WideVec traction, moment;
  Wide damped = 0.0, rubbed = 0.0;
  for (std::size_t p = 0; p < kFacetPoints; ++p) {
    const WideVec at = jump.at(p), spring = at - axes * wide(memory.offset[p]);
    const auto pull = plane_pull<Wide>(law, {pose.normal, spring, rate.at(p), broken, fresh}, dt);
    traction += pull.traction;
    moment += cross(arm.at(p), pull.traction);
    damped += pull.damped;
    rubbed += pull.rubbed;
    const unsigned rests = lanes & bits_of<Wide>(pull.rests);
    if (rests != 0) store(axes.back(at - pull.resting), rests, contact.memory->offset[p]);
  }
  const Wide point_area = 1.0 / kFacetPoints * wide(group.area);
  store(point_area * traction, point_area * moment, pose.between, forces);
  const Wide booked = point_area * wide(contact.weight);
  const Wide by_dashpots = dt * booked * damped, by_friction = 0.5 * booked * shear * rubbed;
  each_lane(lanes, [&](std::size_t k) {
    traces_[g * kGroup + k].open = false;
    losses_.damping += by_dashpots[k];
    losses_.friction += by_friction[k];
  });
}

/// Forces of those of `lanes` that touch; returns which.
unsigned FacetNetwork::close_group(std::size_t g, unsigned lanes, const WidePose& pose, double dt,
                                   WideForces& forces) {
  const WideContact contact = remembered(g, lanes);
  lanes = closing(g, lanes, pose, *contact.memory, dt);
  if (lanes != 0) touch_group(g, lanes, pose, contact, dt, forces);
  return lanes;
}

}  // namespace muckpile
