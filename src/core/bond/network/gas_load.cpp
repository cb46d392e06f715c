// SPDX-License-Identifier: GPL-2.0-or-later
// The pressure of gas in broken joints: openings of joints and forces, a group of facets at once.
// Scope: see the header.
#include "bond/network/gas_load.h"

#include <algorithm>
#include <bit>
#include <limits>

#include "math/byte_lanes.h"

namespace muckpile {
namespace {

/// What a facet of a group has broken, in a byte of each: bit per point that is broken, then one
/// per point that is in contact, then one if it is retired, which carries no contact.
class BrokenBytes {
 public:
  BrokenBytes(const FacetHistory& history, std::size_t group) {
    const std::size_t first = group * kGroup, count = std::min(kGroup, history.size() - first);
    for (std::size_t k = 0; k < count; ++k) {
      const FacetTraces& traces = history.traces(first + k);
      const bool retired = traces.state == FacetState::retired;
      bytes_ |= std::uint64_t{traces.broken.bits() | traces.contact().bits() << kFacetPoints |
                              (retired ? kRetired : 0u)}
                << 8 * k;
    }
  }
  [[nodiscard]] WideMask broken(std::size_t p) const {
    return mask_of<Wide>(lanes_with_bit(bytes_, p));
  }
  [[nodiscard]] WideMask contact(std::size_t p) const {
    return mask_of<Wide>(lanes_with_bit(bytes_, kFacetPoints + p));
  }
  [[nodiscard]] WideMask retired() const {
    return mask_of<Wide>(lanes_with_bit(bytes_, 2 * kFacetPoints));
  }
  /// As OpenJoints::points has them.
  [[nodiscard]] std::uint8_t points(std::size_t lane) const {
    return static_cast<std::uint8_t>(bytes_ >> 8 * lane & (kRetired - 1));
  }

 private:
  static constexpr unsigned kRetired = 1u << 2 * kFacetPoints;
  static_assert(kGroup <= kByteLanes && 2 * kFacetPoints < 8);
  std::uint64_t bytes_ = 0;
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
  const BrokenBytes bytes(facets.history, set.group);
  const WidePose pose = pose_of(group, facets.blocks.state.front());
  const WideField jump = jump_of(group, pose);
  const Wide mean = dot(pose.normal, jump.mean), along_1 = dot(pose.normal, jump.along_1),
             along_2 = dot(pose.normal, jump.along_2);
  Wide opening = 0.0, closure = 0.0, apart = 0.0, points = 0.0;
  for (std::size_t p = 0; p < kFacetPoints; ++p) {
    const WideMask is_broken = bytes.broken(p);
    const Wide zero = wide(contact.offset[p][0]), start = choose(bytes.contact(p), zero, kNever);
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
  Wide closed_by(0.0);  // most joints with gas are open
  closure = choose(bytes.retired(), Wide(0.0), closure);
  if (any_of(closure > 0.0))
    closed_by = wide(contact.fade) * closed_stiffness(facets, set) * closure * per_point;
  const auto note = [&](const Wide& v, std::vector<double>& into) {
    store_lanes(v, set.lanes, into.data() + at);
  };
  note(max(far / radius_squared, sides * sides * turn_of(group, pose).squared()),
       open.parted_squared);
  note(points * wide(group.area) * Wide(1.0 / kFacetPoints), open.area);
  note(sides * opening * per_point, open.opening);
  note(sides * apart * per_point, open.apart);
  note(closed_by, open.pressure);
  const unsigned alone = facets.tables.alone_lanes(set.group);  // only they know apertures
  each_lane(set.lanes, [&](std::size_t k) {
    open.points[at] = bytes.points(k);
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
  const FacetHistory& history = facets.history;
  const unsigned broken = active.lanes & ~history.intact_lanes(active.group);
  if (broken == 0) return 0;
  const FacetGroup& group = facets.tables.group(active.group);
  unsigned lanes = 0;
  for (std::size_t k = 0; k < kGroup; ++k) {  // of all: no branch
    pressure[k] =
        between(static_cast<std::size_t>(group.i[k]), static_cast<std::size_t>(group.j[k]));
    lanes |= (pressure[k] != 0.0 ? 1u : 0u) << k;
  }
  lanes &= broken;
  each_lane(lanes & history.retired_lanes(active.group), [&](std::size_t k) {
    if (!history.traces(active.group * kGroup + k).gas) lanes &= ~(1u << k);
  });
  return lanes;
}

void GasLoad::press(const FacetKinematics& facets, const LaneSet& pressed,
                    const FacetRow<double>& pressure, const WidePose& pose) {
  const FacetGroup& group = facets.tables.group(pressed.group);
  const BrokenBytes bytes(facets.history, pressed.group);
  Wide points = 0.0, on_first = 0.0, on_second = 0.0;  // of the broken ones
  for (std::size_t p = 0; p < kFacetPoints; ++p) {
    const Wide is = choose(bytes.broken(p), Wide(1.0), 0.0);
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
