// SPDX-License-Identifier: GPL-2.0-or-later
// What the facets of a network remember: which points broke, how far each facet has come on its way
// from intact to retired, where broken points rest, and what few facets remember beside that.
// Scope: owned by the network, one row per facet; it travels with the facets as FacetMemory.
// Lengths in m. The states that passes look at often are kept packed beside the traces; only the
// functions below change them, so that the two agree.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "bond/network/contact_rows.h"
#include "bond/network/facet_memory.h"
#include "bond/network/sparse.h"
#include "math/byte_lanes.h"

namespace muckpile {

class FacetHistory {
 public:
  void reset(std::size_t count, std::size_t groups);  ///< so many facets, all intact
  void set(std::size_t f, const FacetMemory& memory);
  void release();  ///< drops all facets and their memory

  [[nodiscard]] std::size_t size() const { return states_.size(); }
  [[nodiscard]] FacetMemory memory(std::size_t f) const;  ///< all of it, put together
  [[nodiscard]] const FacetTraces& traces(std::size_t f) const { return traces_[f]; }
  [[nodiscard]] const std::vector<FacetTraces>& traces() const { return traces_; }
  [[nodiscard]] FacetState state(std::size_t f) const { return states_[f]; }
  [[nodiscard]] const std::vector<FacetState>& states() const { return states_; }
  /// Of a group, bit per facet: those of which every point holds.
  [[nodiscard]] unsigned intact_lanes(std::size_t group) const;
  /// Likewise, those that carry nothing, and lanes without a facet.
  [[nodiscard]] unsigned retired_lanes(std::size_t group) const;
  /// Likewise, those of which no point is in the dilatations and that carry something.
  [[nodiscard]] unsigned apart_lanes(std::size_t group) const;
  /// How many points are in the dilatations.
  [[nodiscard]] int bonded_points(std::size_t f) const { return bonded_points_[f]; }
  [[nodiscard]] const std::vector<std::uint8_t>& bonded_points() const { return bonded_points_; }
  [[nodiscard]] const ContactRows& contacts() const { return contacts_; }
  [[nodiscard]] ContactRows& contacts() { return contacts_; }
  [[nodiscard]] bool has_extra(std::size_t f) const { return extra_.exists(f); }
  /// Of a group, bit per facet.
  [[nodiscard]] unsigned extra_lanes(std::size_t group) const {
    return extra_.existing_of_row<kGroup>(group * kGroup);
  }
  [[nodiscard]] const GroundMemory& ground(std::size_t f) const { return extra_.get(f).ground; }
  [[nodiscard]] GroundMemory& ground_of_support(std::size_t f) {
    return extra_.get_or_create(f).ground;
  }
  [[nodiscard]] const Cohesion& cohesion(std::size_t f, std::size_t p) const {
    return extra_.get(f).cohesion[p];
  }
  [[nodiscard]] Cohesion& cohesion_of_point(std::size_t f, std::size_t p) {
    return extra_.get_or_create(f).cohesion[p];
  }
  /// Of a joint whose law is not grouped.
  [[nodiscard]] const JointHistory& joint(std::size_t f, std::size_t p) const {
    return extra_.get(f).joint[p];
  }
  [[nodiscard]] JointHistory& joint_of_point(std::size_t f, std::size_t p) {
    return extra_.get_or_create(f).joint[p];
  }
  /// A broken point of the facet still sheds its traction gradually.
  [[nodiscard]] bool softens(std::size_t f) const {
    return std::ranges::any_of(extra_.get(f).cohesion, &Cohesion::holds);
  }

  /// Notes where the far side of a support lies, where it remembers anything at all [m].
  void place_ground(std::size_t f, const Vec3& arm_j) {
    if (has_extra(f)) ground_of_support(f).place(arm_j);
  }
  /// A point broke; one that slips stays in the dilatations.
  void break_point(std::size_t f, std::size_t p, bool slips, bool keeps_gas);
  void lose_bonded_point(std::size_t f) { --bonded_points_[f]; }
  void fade(std::size_t f, double matching);
  void retire(std::size_t f);
  void set_open(std::size_t f, bool open) { traces_[f].open = open; }
  void stop_softening(std::size_t f);  ///< of a joint
  void release_gas(std::size_t f) { traces_[f].gas = false; }
  void release_gas() {
    for (FacetTraces& traces : traces_) traces.gas = false;
  }
  void stop_ground();
  /// What softening points hold falls to that share.
  void soften(double factor);

  [[nodiscard]] double bytes_of_traces() const;
  [[nodiscard]] double bytes_of_contacts() const { return contacts_.memory_usage(); }
  [[nodiscard]] double bytes_of_extra() const { return extra_.memory_usage(); }

 private:
  [[nodiscard]] std::size_t in_group(std::size_t group) const;
  [[nodiscard]] std::uint64_t states_of(std::size_t group) const;

  std::vector<FacetTraces> traces_;
  std::vector<FacetState> states_;           // as in traces_
  std::vector<std::uint8_t> bonded_points_;  // as traces_ have it
  ContactRows contacts_;
  SparseTable<ExtraMemory> extra_;
};

inline std::size_t FacetHistory::in_group(std::size_t group) const {
  return std::min(kGroup, states_.size() - group * kGroup);
}

inline std::uint64_t FacetHistory::states_of(std::size_t group) const {
  static_assert(sizeof(FacetState) == 1 && kGroup <= kByteLanes);
  return load_bytes<kGroup>(states_.data() + group * kGroup, in_group(group),
                            static_cast<std::uint8_t>(FacetState::retired));
}

inline unsigned FacetHistory::intact_lanes(std::size_t group) const {
  return lanes_equal(states_of(group), static_cast<std::uint8_t>(FacetState::intact));
}

inline unsigned FacetHistory::retired_lanes(std::size_t group) const {
  return lanes_equal(states_of(group), static_cast<std::uint8_t>(FacetState::retired));
}

inline unsigned FacetHistory::apart_lanes(std::size_t group) const {
  const std::uint64_t bonded =
      load_bytes<kGroup>(bonded_points_.data() + group * kGroup, in_group(group), 1);
  return lanes_equal(bonded, 0) & ~retired_lanes(group);
}

}  // namespace muckpile
