// SPDX-License-Identifier: GPL-2.0-or-later
// Broken points of facets that hold at no point: those of a group at once.
// Scope: as broken_contact.cpp works them out one by one.
#include <array>
#include <cmath>

#include "bond/law/plane_contact.h"
#include "bond/network/broken_contact.h"

namespace muckpile {
namespace {

/// `closed`: stiffness of faces that match wholly [Pa/m].
template <class Closure>
[[gnu::always_inline]] inline Closure closure_of(const Wide& fade, const Wide& closed,
                                                 const Wide& wall_strength) {
  if constexpr (Crushing<Closure>)
    return {fade, closed, wall_strength};
  else
    return {fade * closed};
}

/// Opening at which the first point of each facet carries a pressure [m].
[[gnu::always_inline]] inline Wide closing_of(const ContactGroup& memory) {
  const auto along = [&](std::size_t p) { return wide(memory.offset[p][0]); };
  static_assert(kFacetPoints == 3);
  return max(along(0), max(along(1), along(2)));
}

}  // namespace

/// What the contact of a group's facets remembers, and what else its law needs.
struct BrokenContact::Remembered {
  ContactGroup* memory;
  FacetRow<double> fresh{}, tan_residual{}, weight{}, rock_share{};
  FacetRow<double> shear_over_p_wave{}, dashpot{};  // where there is more than one rock
  FacetRow<double> wall_strength{};                 // where walls crush
};

unsigned BrokenContact::apart_lanes(const LaneSet& working) const {
  const unsigned apart = working.lanes & ~facets_.tables.alone_lanes(working.group) &
                         history_.apart_lanes(working.group);
  return apart == 0 ? 0u : apart & ~history_.extra_lanes(working.group);
}

BrokenContact::Remembered BrokenContact::remembered(std::size_t g, unsigned lanes) {
  Remembered contact{&history_.contacts().remember(g, lanes)};
  const bool crushes = facets_.tables.laws().crushes();
  each_lane(lanes, [&](std::size_t k) {
    const std::size_t f = g * kGroup + k;
    contact.fresh[k] = history_.traces(f).open ? 1.0 : 0.0;
    contact.weight[k] = facets_.tables.name(f).weight;
    contact.rock_share[k] = facets_.tables.rock_share(f);
    contact.tan_residual[k] = facets_.tables.strength(f).tan_residual;
    if (crushes) contact.wall_strength[k] = facets_.tables.wall_strength(f);
    if (!facets_.tables.laws().zoned()) return;
    contact.shear_over_p_wave[k] = facets_.tables.shear_over_p_wave(f);
    contact.dashpot[k] = facets_.tables.laws().contact_damping(facets_.tables.name(f).law);
  });
  return contact;
}

/// Lets facets fade whose sides match less than before.
void BrokenContact::fade_lanes(std::size_t g, unsigned lanes, const FacetParting<Wide>& parting,
                               const ContactGroup& memory) {
  const Wide slid = sqrt(parting.slid / parting.radius_squared);
  const Wide turned = sqrt(parting.turn.squared());
  each_lane(lanes, [&](std::size_t k) {
    const double matching = matching_faces(slid[k], turned[k]);
    if (matching >= memory.fade[k]) return;
    const std::size_t f = g * kGroup + k;
    fade(f, facets_.motion(f), matching);
  });
}

/// Those of `lanes` that touch; the others are open or retire.
unsigned BrokenContact::remaining_lanes(std::size_t g, unsigned lanes, const WidePose& pose,
                                        const ContactGroup& memory) {
  const FacetParting<Wide> parting = parting_of(facets_.tables.group(g), pose);
  const unsigned fading = lanes & bits_of<Wide>(parting.begins_to_fade());
  if (fading != 0) fade_lanes(g, fading, parting, memory);
  const Wide closes_at = closing_of(memory);
  const unsigned gone = lanes & bits_of<Wide>(parting.gone(closes_at) || wide(memory.fade) == 0.0);
  each_lane(gone, [&](std::size_t k) { retire(g * kGroup + k); });
  unsigned open = lanes & ~gone & bits_of<Wide>(parting.open_by(kSurelyOpen));
  if (open == 0) return lanes & ~gone;
  open &= bits_of<Wide>(parting.surely_open(closes_at));
  each_lane(open, [&](std::size_t k) { history_.set_open(g * kGroup + k, true); });
  return lanes & ~gone & ~open;
}

/// Forces of facets that touch, as add_tractions() has them. `Closure` is that of their points.
template <template <class> class Closure>
void BrokenContact::touch(std::size_t g, unsigned lanes, const WidePose& pose,
                          const Remembered& contact, WideForces& forces) {
  const FacetGroup& group = facets_.tables.group(g);
  const JointLaws& laws = facets_.tables.laws();
  const WideField rate = rate_of(group, pose, facets_.blocks.state.front()),
                  jump = jump_of(group, pose);
  const WideVec half_1 = pose.sum * wide(group.half_1), half_2 = pose.sum * wide(group.half_2);
  const WideField arm = {pose.arm(), Wide(0.5) * half_1, Wide(0.5) * half_2};
  const FacetAxes<WideVec> own(pose.normal, half_1);
  const WideMat axes = {own.normal, own.along, own.across};
  const ContactGroup& memory = *contact.memory;
  const Wide fade = choose(mask_of<Wide>(lanes), wide(memory.fade), 0.0),
             shear = fade * wide(group.shear);
  const LinearClosure<Wide> bonded{wide(group.shear), wide(group.normal_extra)};
  const bool zoned = laws.zoned();
  const Wide shear_over_p_wave =
      zoned ? wide(contact.shear_over_p_wave) : Wide(laws.shear_over_p_wave());
  const Wide dashpot = choose(at_mirror(group), Wide(2.0), 1.0) *
                       (zoned ? wide(contact.dashpot) : Wide(laws.contact_damping()));
  const Wide closed = bonded.contact(wide(contact.rock_share), shear_over_p_wave);
  const CoulombStrength<Wide> joint{.tan_residual = wide(contact.tan_residual)};
  const Wide grip = choose(at_mirror(group), Wide(0.0), 1.0);
  const PlaneContact law{
      closure_of<Closure<Wide>>(fade, closed, wide(contact.wall_strength)), shear, fade * dashpot,
      SlipFriction<Wide, CoulombStrength<Wide>>{joint, 0.0, grip, laws.slip_weakening()}};
  const WideMask broken = fade > 0.0, fresh = wide(contact.fresh) > 0.0;
  WideVec traction, moment;
  Wide damped = 0.0, rubbed = 0.0, crushed = 0.0;
  for (std::size_t p = 0; p < kFacetPoints; ++p) {
    const WideVec at = jump.at(p), spring = at - axes * wide(memory.offset[p]);
    const auto pull =
        plane_pull(law, PlanePoint<Wide>{pose.normal, spring, rate.at(p), broken, fresh}, dt_);
    traction += pull.traction;
    moment += cross(arm.at(p), pull.traction);
    damped += pull.damped;
    rubbed += pull.rubbed;
    crushed += pull.crushed;
    const unsigned yields = lanes & bits_of<Wide>(pull.yields);
    if (yields != 0) store(axes.back(at - pull.elastic), yields, contact.memory->offset[p]);
  }
  const Wide point_area = 1.0 / kFacetPoints * wide(group.area);
  store(point_area * traction, point_area * moment, pose.between, forces);
  const Wide booked = point_area * wide(contact.weight);
  const Wide by_dashpots = dt_ * booked * damped, by_friction = 0.5 * booked * shear * rubbed,
             by_crushing = 0.5 * booked * fade * closed * crushed;
  each_lane(lanes, [&](std::size_t k) {
    history_.set_open(g * kGroup + k, false);
    books_.losses.damping += by_dashpots[k];
    books_.losses.friction += by_friction[k];
    if constexpr (Crushing<Closure<Wide>>) books_.losses.crush(by_crushing[k]);
  });
}

unsigned BrokenContact::find_forces(std::size_t g, unsigned lanes, const WidePose& pose,
                                    WideForces& forces) {
  const Remembered contact = remembered(g, lanes);
  lanes = remaining_lanes(g, lanes, pose, *contact.memory);
  if (lanes == 0) return lanes;
  if (facets_.tables.laws().crushes())
    touch<CrushingContact>(g, lanes, pose, contact, forces);
  else
    touch<LinearContact>(g, lanes, pose, contact, forces);
  return lanes;
}

}  // namespace muckpile
