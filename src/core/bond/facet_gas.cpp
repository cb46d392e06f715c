// SPDX-License-Identifier: GPL-2.0-or-later
// Gas in the broken joints of the facet network: how far they are open, and the forces of its
// pressure.
// Scope: see facet_network.h; how much gas is where is gas/joint_gas.h.
#include <algorithm>
#include <cmath>
#include <limits>

#include "bond/facet_wide.h"

namespace muckpile {
namespace {

// A joint that has retired still holds gas between its two blocks. It is in the open once it has
// opened or slid by its radius, or turned by a radian: there is more void than joint then.
constexpr double kWide = 1.0;

}  // namespace

std::span<double> FacetNetwork::gas_pressure() {
  if (gas_pressure_.size() != blocks_.size()) {
    gas_pressure_.assign(blocks_.size(), 0.0);
    gas_force_.assign(blocks_.size(), Vec3::Zero());
    gas_torque_.assign(blocks_.size(), Vec3::Zero());
  }
  return gas_pressure_;
}

void FacetNetwork::open_joints(std::span<const std::uint32_t> facets,
                               std::vector<OpenJoint>& open) const {
  open.clear();
  std::vector<LaneSet> sets;
  for (const std::uint32_t f : facets) add_facet(sets, f);
  for (std::size_t k = 0; k < sets.size(); ++k) {
    if (k + kContactsAhead < sets.size()) fetch_contacts(sets[k + kContactsAhead]);
    open_group_of_joints(sets[k], open);
  }
}

/// How far each broken point has opened since it broke, by what it remembers of that.
void FacetNetwork::open_group_of_joints(const LaneSet& set, std::vector<OpenJoint>& open) const {
  const FacetGroup& group = groups_[set.group];
  FacetRows<double> start;    // per point; further than one in the dilatations opens
  FacetRow<double> broken{};  // points
  const ContactGroup& contact = contacts_.of(set.group);
  for (FacetRow<double>& row : start) row.fill(std::numeric_limits<double>::max());
  each_lane(set.lanes, [&](std::size_t k) {
    const FacetTraces& memory = traces_[set.group * kGroup + k];
    for (std::size_t p = 0; p < kFacetPoints; ++p) {
      broken[k] += memory.broken[p] ? 1.0 : 0.0;
      if (memory.is_contact(p)) start[p][k] = contact.offset[p][0][k];
    }
  });
  const WidePose pose = pose_of(group);
  const WideField jump = jump_of(group, pose);
  Wide opening = 0.0;
  for (std::size_t p = 0; p < kFacetPoints; ++p)
    opening += max(Wide(0.0), dot(pose.normal, jump.at(p)) - wide(start[p]));
  const Wide radius_squared = M_1_PI * wide(group.area);
  const WideMask wide_open = dot(pose.jump, pose.jump) > kWide * kWide * radius_squared ||
                             turn_of(group, pose).exceeds(kWide);
  each_lane(set.lanes, [&](std::size_t k) {
    open.push_back(broken[k] == 0.0 ? OpenJoint{}
                                    : OpenJoint{broken[k] * group.area[k] / kFacetPoints,
                                                opening[k] / broken[k], wide_open[k]});
  });
}

void FacetNetwork::release_gas() {
  gas_pressure_.clear();
  keeps_gas_ = false;
  for (FacetTraces& memory : traces_) memory.gas = false;
}

/// Those of a group's facets in which gas presses, and how hard [Pa]: one of the ground has that of
/// its block.
unsigned FacetNetwork::pressed_lanes(const LaneSet& active, FacetRow<double>& pressure) const {
  const FacetGroup& group = groups_[active.group];
  unsigned lanes = 0;
  each_lane(active.lanes, [&](std::size_t k) {
    const std::size_t f = active.group * kGroup + k;
    if (states_[f] == FacetState::intact) return;
    const double of_i = gas_pressure_[static_cast<std::size_t>(group.i[k])];
    const double of_j =
        group.j[k] == ground() ? of_i : gas_pressure_[static_cast<std::size_t>(group.j[k])];
    pressure[k] = 0.5 * (of_i + of_j);
    if (pressure[k] != 0.0 && !traces_[f].over()) lanes |= 1u << k;
  });
  return lanes;
}

/// The gas pushes the two sides of each facet apart at its broken points.
void FacetNetwork::press_group(std::size_t g, unsigned lanes, const FacetRow<double>& pressure) {
  const FacetGroup& group = groups_[g];
  FacetRows<double> points{};  // of the broken ones: how many, their shares of the half axes
  each_lane(lanes, [&](std::size_t k) {
    for (std::size_t p = 0; p < kFacetPoints; ++p) {
      if (!traces_[g * kGroup + k].broken[p]) continue;
      points[0][k] += 1.0;
      points[1][k] += kOnFirst[p];
      points[2][k] += kOnSecond[p];
    }
  });
  const WidePose pose = pose_of(group);
  const WideVec arms = wide(points[0]) * pose.arm() +
                       Wide(0.5) * (wide(points[1]) * (pose.sum * wide(group.half_1)) +
                                    wide(points[2]) * (pose.sum * wide(group.half_2)));
  const WideVec at_point = -1.0 / kFacetPoints * wide(group.area) * wide(pressure) * pose.normal;
  const WideVec force = wide(points[0]) * at_point, moment = cross(arms, at_point);
  WideForces forces;
  store(force, moment, pose.between, forces);
  each_lane(lanes, [&](std::size_t k) { add_forces(group, k, forces, gas_force_, gas_torque_); });
}

/// Its forces are kept for the gas's work. It does not enter the dilatations, as the contact of
/// broken points does not.
void FacetNetwork::press_joints() {
  if (gas_pressure_.size() != blocks_.size()) return;
  std::fill(gas_force_.begin(), gas_force_.end(), Vec3::Zero());
  std::fill(gas_torque_.begin(), gas_torque_.end(), Vec3::Zero());
  for (const LaneSet& active : active_) {
    FacetRow<double> pressure{};
    const unsigned lanes = pressed_lanes(active, pressure);
    if (lanes != 0) press_group(active.group, lanes, pressure);
  }
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    force_[b] += gas_force_[b];
    torque_[b] += gas_torque_[b];
  }
}

}  // namespace muckpile
