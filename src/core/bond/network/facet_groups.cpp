// SPDX-License-Identifier: GPL-2.0-or-later
// The facet network where facets hold at every point: a group of them at once.
// Scope: dilatations and forces of intact facets, as facet_bond.cpp works them out one by one.
#include <algorithm>
#include <array>
#include <cmath>

#include "bond/network/facet_wide.h"

namespace muckpile {
namespace {

/// A number of each facet's block.
template <class Of>
[[gnu::always_inline]] inline Wide gather_of(const FacetRow<std::int32_t>& blocks, const Of& of) {
  return Wide([&](auto lane) { return of(static_cast<std::size_t>(blocks[lane])); });
}

}  // namespace

unsigned FacetNetwork::whole_lanes(std::size_t group) const {
  const std::size_t first = group * kGroup;
  unsigned lanes = 0;
  for (std::size_t k = 0; k < kGroup && first + k < states_.size(); ++k)
    lanes |= (states_[first + k] == FacetState::intact ? 1u : 0u) << k;
  return lanes;
}

/// The parts of facets in the dilatations of their blocks.
void FacetNetwork::open_group(const LaneSet& bonded) {
  const unsigned whole = bonded.lanes & whole_lanes(bonded.group);
  const FacetGroup& group = groups_[bonded.group];
  alignas(64) FacetRow<double> of_i{}, of_j{};
  if (whole != 0) {
    const WidePose pose = pose_of(group);
    const WideVec turned_back = pose.sum.back(pose.jump);
    const Wide share = wide(group.area) * wide(group.bulk) * pose.scale;
    (share * dot(wide(group.opening_i), turned_back))
        .copy_to(of_i.data(), std::experimental::element_aligned);
    (share * dot(wide(group.opening_j), turned_back))
        .copy_to(of_j.data(), std::experimental::element_aligned);
  }
  for (std::size_t k = 0; k < kGroup; ++k) {
    if ((whole >> k & 1u) != 0) {
      sums_[static_cast<std::size_t>(group.i[k])].bonded += of_i[k];
      sums_[static_cast<std::size_t>(group.j[k])].bonded += of_j[k];
    } else if (bonded.has(k) && bonded_points_[bonded.group * kGroup + k] > 0) {
      open_facet(bonded.group * kGroup + k);
    }
  }
}

[[gnu::always_inline]] inline FacetNetwork::WideField FacetNetwork::pull_of(
    const FacetGroup& group, const WidePose& pose) const {
  const LinearClosure<Wide> closure{wide(group.shear), wide(group.normal_extra)};
  const auto pull = [&](const WideVec& jump) { return closure.traction(pose.normal, jump); };
  const auto stress = [&](std::size_t b) { return bulk_stress_[b]; };
  const WideVec squeezed = gather_of(group.i, stress) * wide(group.opening_i) +
                           gather_of(group.j, stress) * wide(group.opening_j);
  return {pull(pose.jump) + wide(group.bulk) * pose.scale * (pose.sum * squeezed),
          pull(pose.difference * wide(group.half_1)), pull(pose.difference * wide(group.half_2))};
}

/// A mirror has no shear that would stop a block that slides along it, so its facet lets go where
/// broken ones begin to fade: the point at which it acts would stay behind.
[[gnu::always_inline]] inline unsigned FacetNetwork::slid_along(const FacetGroup& group,
                                                                const WidePose& pose) {
  const WideMask smooth = wide(group.shear) == 0.0;
  if (none_of(smooth)) return 0;
  const Wide opened = dot(pose.normal, pose.jump);
  const Wide slid = dot(pose.jump, pose.jump) - opened * opened;
  return bits_of<Wide>(smooth && slid > kSlideStart * kSlideStart * M_1_PI * wide(group.area));
}

/// Those of `lanes` of which no point fails.
[[gnu::always_inline]] inline unsigned FacetNetwork::holding(std::size_t g, unsigned lanes,
                                                             const WidePose& pose,
                                                             const WideField& pull) const {
  FacetRow<double> tension{}, cohesion{}, tan_friction{};
  for (std::size_t k = 0; k < kGroup; ++k) {
    const std::size_t f = std::min(g * kGroup + k, facets_.size() - 1);
    const CoulombStrength<double>& strength = strengths_[facets_[f].joint_class].bonded;
    tension[k] = strength.tension;
    cohesion[k] = strength.cohesion;
    tan_friction[k] = strength.tan_friction;
  }
  const CoulombStrength<Wide> strength{wide(tension), wide(cohesion), wide(tan_friction)};
  WideMask fails = turn_of(groups_[g], pose).exceeds(kTurnStart);
  for (std::size_t p = 0; p < kFacetPoints; ++p)
    fails = fails || strength.fails(pose.normal, pull.at(p));
  return lanes & ~bits_of<Wide>(fails) & ~slid_along(groups_[g], pose);
}

/// Adds the dashpots of the joints, and what they take to `forces`.
[[gnu::always_inline]] inline void FacetNetwork::damp_group(std::size_t g, const WidePose& pose,
                                                            WideField& pull, double dt,
                                                            WideForces& forces) const {
  const FacetGroup& group = groups_[g];
  FacetRow<double> dashpot;
  dashpot.fill(damping_);
  if (!yielding_.empty()) {  // that ground has a dashpot itself
    for (std::size_t k = 0, f = g * kGroup; k < kGroup && f < facets_.size(); ++k, ++f)
      if (facets_[f].kind != FacetKind::joint && ground_memory(f).yields) dashpot[k] = 0.0;
  }
  const WideField rate = rate_of(group, pose);
  const Wide half(0.5);
  const Wide c = wide(dashpot);
  pull.mean += c * rate.mean;
  pull.along_1 += c * rate.along_1;
  pull.along_2 += c * rate.along_2;
  // Of the squares of the weights of three points each half axis has 3/2, their products nothing.
  const Wide squares = dot(rate.mean, rate.mean) +
                       half * (dot(rate.along_1, rate.along_1) + dot(rate.along_2, rate.along_2));
  (Wide(dt) * c * wide(group.area) * squares)
      .copy_to(forces.damped.data(), std::experimental::element_aligned);
}

/// Forces of those of `lanes` of which no point fails; returns which.
unsigned FacetNetwork::hold_group(std::size_t g, unsigned lanes, const WidePose& pose, double dt,
                                  WideForces& forces) const {
  const FacetGroup& group = groups_[g];
  WideField pull = pull_of(group, pose);
  if (slanted()) {
    const auto slant = [&](Eigen::Index d) {
      return Wide([&](auto lane) { return slant_traction_[g * kGroup + lane][d]; });
    };
    pull.mean += WideVec(slant(0), slant(1), slant(2));
  }
  lanes = holding(g, lanes, pose, pull);
  if (damping_ != 0.0) damp_group(g, pose, pull, dt, forces);
  const Wide area = wide(group.area);
  const WideVec arm = pose.arm();
  const WideVec turning = cross(pose.sum * wide(group.half_1), pull.along_1) +
                          cross(pose.sum * wide(group.half_2), pull.along_2);
  const WideVec force = area * pull.mean;
  const WideVec moment = cross(arm, force) + Wide(0.25) * area * turning;
  store(force, moment, pose.between, forces);
  return lanes;
}

/// Waiting for what broken facets remember took longer than working with it.
void FacetNetwork::fetch_contacts(const LaneSet& working) const {
  unsigned awake = 0;
  each_lane(working.lanes, [&](std::size_t k) {
    awake |= (asleep_[working.group * kGroup + k] <= calls_ ? 1u : 0u) << k;
  });
  contacts_.fetch(working.group, awake);
}

/// Gas presses between blocks at rest, too.
void FacetNetwork::work_groups(double dt) {
  std::fill(gas_force_.begin(), gas_force_.end(), Vec3::Zero());
  std::fill(gas_torque_.begin(), gas_torque_.end(), Vec3::Zero());
  std::size_t k = 0;
  for (const LaneSet& active : has_gas() ? active_ : working_) {
    LaneSet working{active.group, 0};
    if (k < working_.size() && working_[k].group == active.group) {
      working = working_[k];
      if (++k + kContactsAhead <= working_.size()) fetch_contacts(working_[k + kContactsAhead - 1]);
    }
    work_group(working, active, dt);
  }
}

/// Forces of those that work, and of the gas in all that are active.
void FacetNetwork::work_group(const LaneSet& working, const LaneSet& active, double dt) {
  const std::size_t g = working.group;
  const FacetGroup& group = groups_[g];
  const unsigned whole = working.lanes & whole_lanes(g), apart = apart_lanes(working);
  unsigned held = 0, touching = 0;
  WideForces held_forces, touching_forces;
  const auto add = [&] {
    each_lane(working.lanes & ~(apart & ~touching), [&](std::size_t k) {
      const std::size_t f = g * kGroup + k;
      if ((touching >> k & 1u) != 0) {
        add_forces(group, k, touching_forces, force_, torque_);
      } else if ((held >> k & 1u) != 0) {
        add_forces(group, k, held_forces, force_, torque_);
        if (damping_ != 0.0) losses_.damping += facets_[f].weight * held_forces.damped[k];
      } else if (states_[f] != FacetState::retired && asleep_[f] <= calls_) {
        work_facet(f, dt);
      }
    });
  };
  FacetRow<double> pressure{};
  if ((whole | apart) == 0 && pressed_lanes(active, pressure) == 0) return add();
  const WidePose pose = pose_of(group);
  if (whole != 0) held = hold_group(g, whole, pose, dt, held_forces);
  if (apart != 0) touching = close_group(g, apart, pose, dt, touching_forces);
  add();
  const LaneSet pressed{active.group,
                        pressed_lanes(active, pressure)};  // of those just broken, too
  if (pressed.lanes != 0) press_group(pressed, pressure, pose);
}

}  // namespace muckpile
