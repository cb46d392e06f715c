// SPDX-License-Identifier: GPL-2.0-or-later
// Forces of facets: a group of them at once where they hold at every point or at none.
// Scope: see the header.
#include "bond/network/traction_pass.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "bond/network/border_relief.h"
#include "bond/network/joint_points.h"
#include "bond/network/softening_points.h"

namespace muckpile {
namespace {

/// A number of each facet's block.
template <class Of>
[[gnu::always_inline]] inline Wide gather_of(const FacetRow<std::int32_t>& blocks, const Of& of) {
  return Wide([&](auto lane) { return of(static_cast<std::size_t>(blocks[lane])); });
}

}  // namespace

[[gnu::always_inline]] inline WideField TractionPass::pull_of(const FacetGroup& group,
                                                              const WidePose& pose) const {
  const LinearClosure<Wide> closure{wide(group.shear), wide(group.normal_extra)};
  const auto pull = [&](const WideVec& jump) { return closure.traction(pose.normal, jump); };
  const std::vector<double>& bulk_stress = facets_.blocks.bulk_stress;
  const auto stress = [&](std::size_t b) { return bulk_stress[b]; };
  const WideVec squeezed = gather_of(group.i, stress) * wide(group.opening_i) +
                           gather_of(group.j, stress) * wide(group.opening_j);
  return {pull(pose.jump) + wide(group.bulk) * pose.scale * (pose.sum * squeezed),
          pull(pose.difference * wide(group.half_1)), pull(pose.difference * wide(group.half_2))};
}

/// A mirror has no shear that would stop a block that slides along it, so its facet lets go where
/// broken ones begin to fade: the point at which it acts would stay behind.
[[gnu::always_inline]] inline unsigned TractionPass::slid_along(const FacetGroup& group,
                                                                const WidePose& pose) {
  const WideMask smooth = at_mirror(group);
  if (none_of(smooth)) return 0;
  return bits_of<Wide>(smooth && parting_of(group, pose).slid_away());
}

/// Those of `lanes` of which no point fails.
[[gnu::always_inline]] inline unsigned TractionPass::unbroken_lanes(std::size_t g, unsigned lanes,
                                                                    const WidePose& pose,
                                                                    const WideField& pull) const {
  const FacetTables& tables = facets_.tables;
  FacetRow<double> tension{}, cohesion{}, tan_friction{};
  for (std::size_t k = 0; k < kGroup; ++k) {
    const std::size_t f = std::min(g * kGroup + k, tables.size() - 1);
    const CoulombStrength<double>& strength = tables.strength(f);
    tension[k] = strength.tension;
    cohesion[k] = strength.cohesion;
    tan_friction[k] = strength.tan_friction;
  }
  const CoulombStrength<Wide> strength{wide(tension), wide(cohesion), wide(tan_friction)};
  WideMask fails = turn_of(tables.group(g), pose).exceeds(kTurnStart);
  for (std::size_t p = 0; p < kFacetPoints; ++p)
    fails = fails || PointLoad<Wide>(pose.normal, pull.at(p)).breaks(strength);
  return lanes & ~bits_of<Wide>(fails) & ~slid_along(tables.group(g), pose);
}

/// Adds the dashpots of the joints, and what they take to `forces`. Those at a mirror act on the
/// speed at which block and image part.
[[gnu::always_inline]] inline void TractionPass::damp_group(std::size_t g, const WidePose& pose,
                                                            WideField& pull,
                                                            WideForces& forces) const {
  const FacetTables& tables = facets_.tables;
  const FacetGroup& group = tables.group(g);
  FacetRow<double> dashpot;
  dashpot.fill(tables.laws().damping());
  if (tables.laws().zoned()) {
    for (std::size_t k = 0, f = g * kGroup; k < kGroup && f < tables.size(); ++k, ++f)
      dashpot[k] = tables.laws().damping(tables.name(f).law);
  }
  if (ground_yields_) {  // that ground has a dashpot itself
    for (std::size_t k = 0, f = g * kGroup; k < kGroup && f < tables.size(); ++k, ++f)
      if (!tables.is_joint(f) && facets_.history.ground(f).yields) dashpot[k] = 0.0;
  }
  WideField rate = rate_of(group, pose, facets_.blocks.state.front());
  const Wide half(0.5);
  Wide c = wide(dashpot);
  if (const WideMask mirror = at_mirror(group); any_of(mirror)) {
    c = choose(mirror, Wide(2.0), 1.0) * c;
    for (WideVec* part : {&rate.mean, &rate.along_1, &rate.along_2})
      *part = choose(mirror, dot(pose.normal, *part) * pose.normal, *part);
  }
  pull.mean += c * rate.mean;
  pull.along_1 += c * rate.along_1;
  pull.along_2 += c * rate.along_2;
  // Of the squares of the weights of three points each half axis has 3/2, their products nothing.
  const Wide squares = dot(rate.mean, rate.mean) +
                       half * (dot(rate.along_1, rate.along_1) + dot(rate.along_2, rate.along_2));
  (Wide(dt_) * c * wide(group.area) * squares)
      .copy_to(forces.damped.data(), std::experimental::element_aligned);
}

/// Forces of those of `lanes` of which no point fails; returns which.
unsigned TractionPass::intact_forces(std::size_t g, unsigned lanes, const WidePose& pose,
                                     WideForces& forces) const {
  const FacetGroup& group = facets_.tables.group(g);
  WideField pull = pull_of(group, pose);
  if (parts_.leaning != nullptr) {
    const auto leaning = [&](Eigen::Index d) {
      return Wide([&](auto lane) { return parts_.leaning->traction(g * kGroup + lane)[d]; });
    };
    pull.mean += WideVec(leaning(0), leaning(1), leaning(2));
  }
  if (const unsigned borders = facets_.tables.border_lanes(g); borders != 0) {
    FacetRow<double> relief{};
    each_lane(borders,
              [&](std::size_t k) { relief[k] = border_traction(facets_, g * kGroup + k); });
    pull.mean += wide(relief) * pose.normal;
  }
  lanes = unbroken_lanes(g, lanes, pose, pull);
  if (facets_.tables.laws().damps()) damp_group(g, pose, pull, forces);
  const Wide area = wide(group.area);
  const WideVec arm = pose.arm();
  const WideVec turning = cross(pose.sum * wide(group.half_1), pull.along_1) +
                          cross(pose.sum * wide(group.half_2), pull.along_2);
  const WideVec force = area * pull.mean;
  const WideVec moment = cross(arm, force) + Wide(0.25) * area * turning;
  store(force, moment, pose.between, forces);
  return lanes;
}

/// Beyond the caches, waiting for facets and for what broken ones remember takes a fifth of the
/// pass.
void TractionPass::fetch(const LaneSet& working) const {
  facets_.tables.fetch_group(working.group);
  facets_.history.contacts().fetch(working.group, working.lanes);
}

/// Gas presses between blocks at rest, too.
void TractionPass::run() {
  if (gas_ != nullptr) gas_->clear_forces();
  const FacetSchedule& schedule = parts_.schedule;
  const std::vector<LaneSet>& working_sets = schedule.working();
  std::size_t k = 0;
  for (const LaneSet& active : gas_ != nullptr ? schedule.active() : working_sets) {
    LaneSet working{active.group, 0};
    if (k < working_sets.size() && working_sets[k].group == active.group) {
      working = working_sets[k];
      if (++k + kGroupsAhead <= working_sets.size()) fetch(working_sets[k + kGroupsAhead - 1]);
    }
    work_group(working, active);
  }
}

/// Forces of those that work, and of the gas in all that are active.
void TractionPass::work_group(const LaneSet& working, const LaneSet& active) {
  const std::size_t g = working.group;
  const unsigned whole = working.lanes & facets_.history.intact_lanes(g) &
                         ~facets_.tables.alone_lanes(g),
                 apart = broken_.apart_lanes(working);
  const auto pressed_lanes = [&](FacetRow<double>& pressure) {
    return gas_ == nullptr ? 0u : gas_->pressed_lanes(facets_, active, pressure);
  };
  FacetRow<double> pressure{};
  if ((whole | apart) == 0 && pressed_lanes(pressure) == 0)
    return each_lane(working.lanes, [&](std::size_t k) { work_alone(g * kGroup + k); });
  const WidePose pose = pose_of(facets_.tables.group(g), facets_.blocks.state.front());
  GroupForces sums;
  if (whole != 0) sums.intact = intact_forces(g, whole, pose, sums.of_intact);
  if (apart != 0) sums.touching = broken_.find_forces(g, apart, pose, sums.of_touching);
  add({working.group, working.lanes & ~(apart & ~sums.touching)}, sums);
  const LaneSet pressed{active.group, pressed_lanes(pressure)};  // of those just broken, too
  if (pressed.lanes != 0) gas_->press(facets_, pressed, pressure, pose);
}

/// Adds what was worked out side by side, and works out the others, in the order of the facets.
[[gnu::always_inline]] inline void TractionPass::add(const LaneSet& working,
                                                     const GroupForces& sums) {
  const std::size_t g = working.group;
  const FacetGroup& group = facets_.tables.group(g);
  BlockFields& blocks = parts_.blocks;
  const bool damps = facets_.tables.laws().damps();
  each_lane(working.lanes, [&](std::size_t k) {
    const std::size_t f = g * kGroup + k;
    if ((sums.touching >> k & 1u) != 0) {
      add_forces(group, k, sums.of_touching, blocks.force, blocks.torque);
    } else if ((sums.intact >> k & 1u) != 0) {
      add_forces(group, k, sums.of_intact, blocks.force, blocks.torque);
      if (damps)
        parts_.books.losses.damping += facets_.tables.name(f).weight * sums.of_intact.damped[k];
    } else {
      work_alone(f);
    }
  });
}

void TractionPass::work_alone(std::size_t f) {
  if (facets_.history.state(f) != FacetState::retired) work_facet(f);
}

/// Forces of any facet: breaks points, and handles broken and damped ones.
void TractionPass::work_facet(std::size_t f) {
  const FacetMotion motion = facets_.motion(f);
  const ContactConstants contact = facets_.tables.contact(f);
  const FacetHistory& history = facets_.history;
  const bool bonded = history.bonded_points(f) > 0;
  if (!bonded && !broken_.remains(f, motion, contact)) return;
  FacetPull pull = bonded ? bonded_.pull(f, motion) : FacetPull(motion);
  const BlockState& si = facets_.blocks.state_of(facets_.tables.i_of(f));
  const BlockState& sj = facets_.blocks.state_of(facets_.tables.j_of(f));
  // The velocity that block j's rock would have at the centre of block i, less that of block i.
  const Vec3 slip = sj.velocity - si.velocity + sj.spin.cross(si.centre - sj.centre);
  pull.rate = LaneVec(slip) + cross(LaneVec(Vec3(sj.spin - si.spin)), pull.arm);
  if (facets_.tables.is_mirror(f)) pull.rate = dot(pull.normal, pull.rate) * pull.normal;
  if (bonded) {
    bonded_.work(f, motion, contact, pull, dt_);
    if (history.bonded_points(f) == 0 && !broken_.remains(f, motion, contact)) return;
  }
  if (history.bonded_points(f) < kFacetPoints) broken_.add_tractions(f, motion, contact, pull);
  if (facets_.tables.laws().softens())
    add_cohesion(facets_, parts_.history, parts_.books.losses, f, motion, pull, dt_);
  remember_closure(facets_, parts_.history, parts_.books.losses, f, motion, contact);
  apply(f, contact.point_area, pull);
}

void TractionPass::apply(std::size_t f, double point_area, const FacetPull& pull) {
  const auto [i, j] = facets_.tables.blocks_of(f);
  BlockFields& blocks = parts_.blocks;
  const LaneVec at_points = choose(is_point(), Lanes(point_area), 0.0) * pull.traction;
  const Vec3 force = sum(at_points), moment = sum(cross(pull.arm, at_points));
  blocks.force[i] += force;
  blocks.torque[i] += moment;
  blocks.force[j] -= force;
  blocks.torque[j] -= moment + (blocks.state[i].centre - blocks.state[j].centre).cross(force);
}

}  // namespace muckpile
