// SPDX-License-Identifier: GPL-2.0-or-later
// Gas in the broken joints of the facet network: how far they are open, and the forces of its
// pressure.
// Scope: see facet_network.h; how much gas is where is gas/joint_gas.h.
#include <algorithm>
#include <cmath>
#include <limits>

#include "bond/network/facet_wide.h"

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

void FacetNetwork::open_joints(std::span<const LaneSet> facets,
                               std::vector<OpenJoint>& open) const {
  open.clear();
  for (std::size_t k = 0; k < facets.size(); ++k) {
    if (k + kContactsAhead < facets.size())
      contacts_.fetch_openings(facets[k + kContactsAhead].group);
    open_group_of_joints(facets[k], open);
  }
}

/// Per point, those of some facets of a group of which `of` has it.
template <class Of>
FacetNetwork::PointLanes FacetNetwork::lanes_with(const LaneSet& set, const Of& of) const {
  PointLanes lanes{};
  each_lane(set.lanes, [&](std::size_t k) {
    const PointSet points = of(traces_[set.group * kGroup + k]);
    for (std::size_t p = 0; p < kFacetPoints; ++p) lanes[p] |= (points[p] ? 1u : 0u) << k;
  });
  return lanes;
}

/// How far each broken point has opened since it broke, by what it remembers of that.
void FacetNetwork::open_group_of_joints(const LaneSet& set, std::vector<OpenJoint>& open) const {
  constexpr double kNever = std::numeric_limits<double>::max();  // a point in the dilatations
  const FacetGroup& group = groups_[set.group];
  const ContactGroup& contact = contacts_.of(set.group);
  const PointLanes broken = lanes_with(set, [](const FacetTraces& m) { return m.broken; });
  const PointLanes parted = lanes_with(set, [](const FacetTraces& m) { return m.contact(); });
  const WidePose pose = pose_of(group);
  const WideField jump = jump_of(group, pose);
  const Wide mean = dot(pose.normal, jump.mean), along_1 = dot(pose.normal, jump.along_1),
             along_2 = dot(pose.normal, jump.along_2);
  Wide opening = 0.0, points = 0.0;
  for (std::size_t p = 0; p < kFacetPoints; ++p) {
    const Wide start = choose(mask_of<Wide>(parted[p]), wide(contact.offset[p][0]), kNever);
    const Wide now = mean + kOnFirst[p] * along_1 + kOnSecond[p] * along_2;
    opening += max(Wide(0.0), now - start);
    points += choose(mask_of<Wide>(broken[p]), Wide(1.0), 0.0);
  }
  const Wide radius_squared = M_1_PI * wide(group.area);
  const unsigned wide_open =
      bits_of<Wide>(points > 0.0 && (dot(pose.jump, pose.jump) > kWide * kWide * radius_squared ||
                                     turn_of(group, pose).exceeds(kWide)));
  alignas(64) FacetRow<double> area, opened;
  store(points * wide(group.area) / Wide(kFacetPoints), area);
  store(opening / max(points, Wide(1.0)), opened);
  each_lane(set.lanes, [&](std::size_t k) {
    open.push_back({area[k], opened[k], (wide_open >> k & 1u) != 0});
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
  if (!has_gas()) return 0;
  const FacetGroup& group = groups_[active.group];
  unsigned lanes = 0;
  each_lane(active.lanes & ~whole_lanes(active.group), [&](std::size_t k) {
    const std::size_t f = active.group * kGroup + k;
    const double of_i = gas_pressure_[static_cast<std::size_t>(group.i[k])];
    const double of_j =
        group.j[k] == ground() ? of_i : gas_pressure_[static_cast<std::size_t>(group.j[k])];
    pressure[k] = 0.5 * (of_i + of_j);
    if (pressure[k] != 0.0 && !traces_[f].over()) lanes |= 1u << k;
  });
  return lanes;
}

/// The gas pushes the two sides of each facet apart at its broken points.
void FacetNetwork::press_group(const LaneSet& pressed, const FacetRow<double>& pressure,
                               const WidePose& pose) {
  const FacetGroup& group = groups_[pressed.group];
  const PointLanes broken = lanes_with(pressed, [](const FacetTraces& m) { return m.broken; });
  Wide points = 0.0, on_first = 0.0, on_second = 0.0;  // of the broken ones
  for (std::size_t p = 0; p < kFacetPoints; ++p) {
    const Wide is = choose(mask_of<Wide>(broken[p]), Wide(1.0), 0.0);
    points += is;
    on_first += kOnFirst[p] * is;
    on_second += kOnSecond[p] * is;
  }
  const WideVec arms =
      points * pose.arm() + Wide(0.5) * (on_first * (pose.sum * wide(group.half_1)) +
                                         on_second * (pose.sum * wide(group.half_2)));
  const WideVec at_point = -1.0 / kFacetPoints * wide(group.area) * wide(pressure) * pose.normal;
  const WideVec force = points * at_point, moment = cross(arms, at_point);
  WideForces forces;
  store(force, moment, pose.between, forces);
  each_lane(pressed.lanes,
            [&](std::size_t k) { add_forces(group, k, forces, gas_force_, gas_torque_); });
}

/// Its forces are kept for the gas's work. It does not enter the dilatations, as the contact of
/// broken points does not.
void FacetNetwork::add_gas_forces() {
  for (std::size_t b = 0; b < gas_force_.size(); ++b) {
    force_[b] += gas_force_[b];
    torque_[b] += gas_torque_[b];
  }
}

}  // namespace muckpile
