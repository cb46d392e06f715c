// SPDX-License-Identifier: GPL-2.0-or-later
// How the facets of a group lean in the present pose, one per lane: for those that hold at every
// point and whose law is linear.
// Scope: for LeaningFaces; reads tables, poses and what blocks remember. Others one by one there.
// SI units.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "bond/network/facet_wide.h"
#include "bond/network/leaning_faces.h"

namespace muckpile {

/// Of some facets of a group, bit per facet.
struct LeaningLanes {
  unsigned on_i = 0, on_j = 0;  ///< those that lean on their block i, and on their block j
  unsigned at_once = 0;         ///< those of them that are worked on side by side

  LeaningLanes(const FacetKinematics& facets, const LaneSet& set) {
    each_lane(set.lanes, [&](std::size_t k) {
      const FacetName& name = facets.tables.name(set.group * kGroup + k);
      on_i |= (name.slanted_i ? 1u : 0u) << k;
      on_j |= (name.slanted_j ? 1u : 0u) << k;
    });
    at_once = (on_i | on_j) & facets.history.intact_lanes(set.group) &
              ~facets.tables.alone_lanes(set.group);
  }
};

/// The facets of a group; lanes that are not worked on side by side have no meaning.
class LeaningGroup {
 public:
  [[gnu::always_inline]] LeaningGroup(const LeaningFaces& faces, const FacetKinematics& facets,
                                      std::size_t g)
      : faces_(faces),
        facets_(facets),
        first_(g * kGroup),
        group_(facets.tables.group(g)),
        pose_(pose_of(group_, facets.blocks.state.front())),
        shear_share_([&](auto lane) { return of_lane(lane).shear_share; }),
        jump_(strained(pose_.jump)) {}

  struct Side {
    const FacetRow<std::int32_t>& blocks;
    WideVec opening, lean;  // m and g in the present pose [-]
  };
  [[nodiscard, gnu::always_inline]] Side side_i() const {
    return {group_.i, turned(wide(group_.opening_i)), lean(0)};
  }
  [[nodiscard, gnu::always_inline]] Side side_j() const {
    return {group_.j, turned(wide(group_.opening_j)), lean(1)};
  }
  /// FacetLean::strained.
  [[nodiscard, gnu::always_inline]] WideVec strained(const WideVec& v) const {
    return shear_share_ * v + (1.0 - shear_share_) * dot(pose_.normal, v) * pose_.normal;
  }
  [[nodiscard]] const WideVec& jump() const { return jump_; }  ///< as strained [m]
  [[nodiscard]] Wide area() const { return wide(group_.area); }
  [[nodiscard]] Wide bulk() const { return wide(group_.bulk); }
  /// A number of the blocks on one side.
  template <class Of>
  [[nodiscard, gnu::always_inline]] Wide number(const Side& side, const Of& of) const {
    return Wide([&](auto lane) { return of(static_cast<std::size_t>(side.blocks[lane])); });
  }
  [[nodiscard, gnu::always_inline]] WideMat tensor(const Side& side,
                                                   const std::vector<Mat3>& of) const {
    const auto at = [&](Eigen::Index r, Eigen::Index c) {
      return number(side, [&](std::size_t b) { return of[b](r, c); });
    };
    return {{at(0, 0), at(1, 0), at(2, 0)},
            {at(0, 1), at(1, 1), at(2, 1)},
            {at(0, 2), at(1, 2), at(2, 2)}};
  }

 private:
  [[nodiscard]] const FacetLean& of_lane(std::size_t lane) const {
    return faces_.facet(std::min(first_ + lane, facets_.tables.size() - 1));
  }
  [[nodiscard, gnu::always_inline]] WideVec turned(const WideVec& start) const {
    return pose_.scale * (pose_.sum * start);
  }
  [[nodiscard, gnu::always_inline]] WideVec lean(std::size_t side) const {
    FacetRows<double> start;
    for (std::size_t k = 0; k < kGroup; ++k) set_lane(start, k, of_lane(k).lean[side]);
    return turned(wide(start));
  }

  const LeaningFaces& faces_;
  const FacetKinematics& facets_;
  std::size_t first_;
  const FacetGroup& group_;
  WidePose pose_;
  Wide shear_share_;
  WideVec jump_;
};

/// What a facet adds on one side: the outer products of `opened` with m to the gradient and with g
/// to E of its block.
struct StretchRows {
  alignas(64) FacetRows<double> opened, opening, lean;

  [[gnu::always_inline]] StretchRows(const LeaningGroup& group, const LeaningGroup::Side& side,
                                     const BlockFields& blocks) {
    const Wide volume = group.number(side, [&](std::size_t b) { return blocks.volume(b); });
    store(group.area() * group.bulk() / volume * group.jump(), opened);
    store(side.opening, opening);
    store(side.lean, lean);
  }
};

}  // namespace muckpile
