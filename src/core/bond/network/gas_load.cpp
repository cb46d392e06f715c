// SPDX-License-Identifier: GPL-2.0-or-later
// The pressure of gas in broken joints: openings of joints and forces, a group of facets at once.
// Scope: see the header.
#include "bond/network/gas_load.h"

#include <algorithm>
#include <bit>
#include <limits>

namespace muckpile {
namespace {

using PointLanes = std::array<unsigned, kFacetPoints>;  // bit per facet of a group

/// Per point, the facets of a group in which it is broken, and in which it is in contact.
struct BrokenLanes {
  PointLanes broken{}, contact{};
  unsigned retired = 0;  // carry no contact

  BrokenLanes(const FacetHistory& history, const LaneSet& set) {
    each_lane(set.lanes, [&](std::size_t k) {
      const FacetTraces& traces = history.traces(set.group * kGroup + k);
      retired |= (traces.state == FacetState::retired ? 1u : 0u) << k;
      const unsigned points = traces.broken.bits(), apart = traces.contact().bits();
      for (std::size_t p = 0; p < kFacetPoints; ++p) {
        broken[p] |= (points >> p & 1u) << k;
        contact[p] |= (apart >> p & 1u) << k;
      }
    });
  }
};

/// Normal stiffness of the closed facets of a group [Pa/m].
Wide closed_stiffness(const FacetKinematics& facets, const LaneSet& set) {
  const FacetGroup& group = facets.tables.group(set.group);
  const auto ground = static_cast<std::int32_t>(facets.blocks.size() - 1);
  const Wide sides([&](auto lane) { return group.j[lane] == ground ? 1.0 : 2.0; });
  Wide shear_share(facets.tables.laws().shear_over_p_wave());
  if (facets.tables.laws().zoned()) {
    FacetRow<double> of_each = ContactGroup::all(1.0);
    each_lane(set.lanes, [&](std::size_t k) {
      of_each[k] = facets.tables.shear_over_p_wave(set.group * kGroup + k);
    });
    shear_share = wide(of_each);
  }
  const LinearClosure<Wide> bonded{wide(group.shear), wide(group.normal_extra)};
  return bonded.contact(sides * wide(group.bulk), shear_share);
}

/// How far each broken point has opened since it broke, by what it remembers of that, written from
/// place `at` on; returns the next free place.
std::size_t open_group_of_joints(const FacetKinematics& facets, const LaneSet& set, std::size_t at,
                                 OpenJoints& open) {
  constexpr double kNever = std::numeric_limits<double>::max();  // a point in the dilatations
  const FacetGroup& group = facets.tables.group(set.group);
  const ContactGroup& contact = facets.history.contacts().of(set.group);
  const auto [broken, parted, retired] = BrokenLanes(facets.history, set);
  const WidePose pose = pose_of(group, facets.blocks.state.front());
  const WideField jump = jump_of(group, pose);
  const Wide mean = dot(pose.normal, jump.mean), along_1 = dot(pose.normal, jump.along_1),
             along_2 = dot(pose.normal, jump.along_2);
  Wide opening = 0.0, closure = 0.0, apart = 0.0, points = 0.0;
  for (std::size_t p = 0; p < kFacetPoints; ++p) {
    const WideMask is_broken = mask_of<Wide>(broken[p]);
    const Wide zero = wide(contact.offset[p][0]),
               start = choose(mask_of<Wide>(parted[p]), zero, kNever);
    const Wide now = mean + kOnFirst[p] * along_1 + kOnSecond[p] * along_2;
    opening += max(Wide(0.0), now - start);
    apart += choose(is_broken, now, 0.0);
    closure += choose(is_broken, max(Wide(0.0), zero - now), 0.0);
    points += choose(is_broken, Wide(1.0), 0.0);
  }
  const Wide per_point = 1.0 / max(points, Wide(1.0));
  const WideMask mirror = at_mirror(group);  // the image opens and turns as much the other way
  const Wide sides = choose(mirror, Wide(2.0), 1.0), along = sides * dot(pose.normal, pose.jump);
  const Wide far = choose(mirror, along * along, dot(pose.jump, pose.jump)),
             radius_squared = M_1_PI * wide(group.area);
  alignas(64) FacetRow<double> area, opened, far_apart, pressure, parted_squared;
  store(max(far / radius_squared, sides * sides * turn_of(group, pose).squared()), parted_squared);
  store(points * wide(group.area) * Wide(1.0 / kFacetPoints), area);
  store(sides * opening * per_point, opened);
  Wide closed_by(0.0);  // most joints with gas are open
  closure = choose(mask_of<Wide>(retired), Wide(0.0), closure);
  if (any_of(closure > 0.0))
    closed_by = wide(contact.fade) * closed_stiffness(facets, set) * closure * per_point;
  store(sides * apart * per_point, far_apart);
  store(closed_by, pressure);
  const unsigned alone = facets.tables.alone_lanes(set.group);  // only they know apertures
  each_lane(set.lanes, [&](std::size_t k) {
    const FacetTraces& traces = facets.history.traces(set.group * kGroup + k);
    open.area[at] = area[k];
    open.opening[at] = opened[k];
    open.apart[at] = far_apart[k];
    open.pressure[at] = pressure[k];
    open.parted_squared[at] = parted_squared[k];
    open.points[at] =
        static_cast<std::uint8_t>(traces.broken.bits() | traces.contact().bits() << kFacetPoints);
    if ((alone >> k & 1u) != 0) {
      if (const auto known = mean_apertures(facets, set.group * kGroup + k))
        open.by_law.push_back({at, *known});
    }
    ++at;
  });
  return at;
}

}  // namespace

void OpenJoints::resize(std::size_t joints) {
  for (auto* numbers : {&area, &opening, &apart, &pressure, &parted_squared})
    numbers->resize(joints);
  points.resize(joints);
  by_law.clear();
}

void open_joints(const FacetKinematics& all, std::span<const LaneSet> facets, OpenJoints& open) {
  std::size_t joints = 0, at = 0;
  for (const LaneSet& set : facets) joints += static_cast<std::size_t>(std::popcount(set.lanes));
  open.resize(joints);
  for (std::size_t k = 0; k < facets.size(); ++k) {
    if (k + kGroupsAhead < facets.size()) {
      const std::size_t ahead = facets[k + kGroupsAhead].group;
      all.tables.fetch_group(ahead);
      all.history.contacts().fetch_openings(ahead);
    }
    at = open_group_of_joints(all, facets[k], at, open);
  }
}

void GasLoad::set_pressure(std::span<const double> pressure) {
  pressure_.assign(pressure.begin(), pressure.end());
  if (force_.size() == pressure.size()) return;
  force_.assign(pressure.size(), Vec3::Zero());
  torque_.assign(pressure.size(), Vec3::Zero());
}

void GasLoad::clear_forces() {
  std::fill(force_.begin(), force_.end(), Vec3::Zero());
  std::fill(torque_.begin(), torque_.end(), Vec3::Zero());
}

unsigned GasLoad::pressed_lanes(const FacetKinematics& facets, const LaneSet& active,
                                FacetRow<double>& pressure) const {
  if (!presses()) return 0;
  const FacetGroup& group = facets.tables.group(active.group);
  unsigned lanes = 0;
  each_lane(active.lanes & ~facets.history.intact_lanes(active.group), [&](std::size_t k) {
    const std::size_t f = active.group * kGroup + k;
    pressure[k] =
        between(static_cast<std::size_t>(group.i[k]), static_cast<std::size_t>(group.j[k]));
    if (pressure[k] != 0.0 && !facets.history.traces(f).over()) lanes |= 1u << k;
  });
  return lanes;
}

void GasLoad::press(const FacetKinematics& facets, const LaneSet& pressed,
                    const FacetRow<double>& pressure, const WidePose& pose) {
  const FacetGroup& group = facets.tables.group(pressed.group);
  const PointLanes broken = BrokenLanes(facets.history, pressed).broken;
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
  each_lane(pressed.lanes, [&](std::size_t k) { add_forces(group, k, forces, force_, torque_); });
}

void GasLoad::add_forces_to(BlockFields& blocks) const {
  for (std::size_t b = 0; b < force_.size(); ++b) {
    blocks.force[b] += force_[b];
    blocks.torque[b] += torque_[b];
  }
}

}  // namespace muckpile
