// SPDX-License-Identifier: GPL-2.0-or-later
// How one facet, or the facets of a group, one per lane, lean in the present pose: what the law of
// leaning_law.h takes. In a group are those that hold at every point and whose law is grouped.
// Scope: for LeaningFaces; reads tables, poses and what blocks remember. SI units.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "bond/law/leaning_law.h"
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

/// One facet.
class LeaningFacet {
 public:
  /// `jump`: the part of its jump that is in the dilatations [m].
  [[gnu::always_inline]] LeaningFacet(const FacetLean& leaning, const FacetKinematics& facets,
                                      std::size_t f, const FacetMotion& motion, const Vec3& jump)
      : leaning_(leaning),
        facets_(facets),
        facet_(f),
        bond_(facets.tables.bond(f)),
        openings_(facets.openings(f, motion.scale)),
        scale_(motion.scale),
        part_{leaning.shear_share, motion.normal},
        jump_(part_.of(jump)) {}

  struct Side : LeaningSide<Vec3> {
    std::size_t block;
    double share;  ///< of the jump that strains the block [-]
  };
  /// Calls `use` with 0 or 1 and the side on block i or j, if it leans there.
  template <class Use>
  [[gnu::always_inline]] void each_side(const Use& use) const {
    const auto [i, j] = facets_.tables.blocks_of(facet_);
    const std::array<bool, 2> leans = facets_.tables.name(facet_).slanted();
    if (leans[0]) use(0, Side{{openings_.i, lean(0)}, i, bond_.bulk_i});
    if (leans[1]) use(1, Side{{openings_.j, lean(1)}, j, bond_.bulk_j});
  }
  [[nodiscard]] const StrainedPart<double, Vec3>& part() const { return part_; }
  [[nodiscard]] const Vec3& jump() const { return jump_; }  ///< as strained [m]
  [[nodiscard]] double area() const { return facets_.tables.area(facet_); }
  /// A number of the block on one side.
  template <class Of>
  [[nodiscard, gnu::always_inline]] double number(const Side& side, const Of& of) const {
    return of(side.block);
  }
  [[nodiscard]] const Mat3& tensor(const Side& side, const std::vector<Mat3>& of) const {
    return of[side.block];
  }

 private:
  [[nodiscard, gnu::always_inline]] Vec3 lean(std::size_t side) const {
    return facets_.turned(facet_, leaning_.lean[side], scale_);
  }

  const FacetLean& leaning_;
  const FacetKinematics& facets_;
  std::size_t facet_;
  BondConstants bond_;
  FacetOpenings openings_;
  double scale_;
  StrainedPart<double, Vec3> part_;
  Vec3 jump_;
};

/// The facets of a group; lanes that are not worked on side by side have no meaning.
class LeaningGroup {
 public:
  [[gnu::always_inline]] LeaningGroup(const LeaningFaces& faces, const FacetKinematics& facets,
                                      std::size_t g, const LeaningLanes& lanes)
      : faces_(faces),
        facets_(facets),
        first_(g * kGroup),
        lanes_(lanes),
        group_(facets.tables.group(g)),
        pose_(pose_of(group_, facets.blocks.state.front())),
        part_{Wide([&](auto lane) { return of_lane(lane).shear_share; }), pose_.normal},
        jump_(part_.of(pose_.jump)) {}

  struct Side : LeaningSide<WideVec> {
    const FacetRow<std::int32_t>& blocks;
    Wide share;  ///< of the jump that strains the block, 0 where the facet does not lean on it [-]
  };
  /// Calls `use` with 0 and 1 and the sides on blocks i and j.
  template <class Use>
  [[gnu::always_inline]] void each_side(const Use& use) const {
    use(0, Side{{turned(wide(group_.opening_i)), lean(0)}, group_.i, share(lanes_.on_i)});
    use(1, Side{{turned(wide(group_.opening_j)), lean(1)}, group_.j, share(lanes_.on_j)});
  }
  [[nodiscard]] const StrainedPart<Wide, WideVec>& part() const { return part_; }
  [[nodiscard]] const WideVec& jump() const { return jump_; }  ///< as strained [m]
  [[nodiscard]] Wide area() const { return wide(group_.area); }
  /// A number of the blocks on one side.
  template <class Of>
  [[nodiscard, gnu::always_inline]] Wide number(const Side& side, const Of& of) const {
    return Wide([&](auto lane) { return of(static_cast<std::size_t>(side.blocks[lane])); });
  }
  [[nodiscard, gnu::always_inline]] WideMat tensor(const Side& side,
                                                   const std::vector<Mat3>& of) const {
    return PlacesOf<Mat3>(side.blocks).matrix(of.front());
  }

 private:
  [[nodiscard]] const FacetLean& of_lane(std::size_t lane) const {
    return faces_.facet(std::min(first_ + lane, facets_.tables.size() - 1));
  }
  [[nodiscard, gnu::always_inline]] Wide share(unsigned on) const {
    return choose(mask_of<Wide>(on), wide(group_.bulk), 0.0);
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
  LeaningLanes lanes_;
  const FacetGroup& group_;
  WidePose pose_;
  StrainedPart<Wide, WideVec> part_;
  WideVec jump_;
};

/// What has opened on one side of a LeaningFacet, or of each facet of a LeaningGroup.
template <class Facets>
[[nodiscard, gnu::always_inline]] inline auto opened_on(const Facets& facets,
                                                        const typename Facets::Side& side,
                                                        const BlockFields& blocks) {
  const auto volume = facets.number(side, [&](std::size_t b) { return blocks.volume(b); });
  return opened(decltype(volume)(facets.area() * side.share), volume, facets.jump());
}

/// Displacement gradients and stresses T of all blocks.
struct BlockTensors {
  const std::vector<Mat3>&gradients, &stresses;
};

/// Of a LeaningFacet, or of each facet of a LeaningGroup.
template <class Facets>
[[nodiscard, gnu::always_inline]] inline auto pull_on(const Facets& facets,
                                                      const BlockTensors& tensors,
                                                      const BlockFields& blocks) {
  LeaningPull pull(facets.part(), facets.jump());
  facets.each_side([&](int, const auto& side) {
    const auto two_g = [&](std::size_t b) { return blocks.rock[b].two_g; };
    pull.add(side.share, side,
             LeaningBlock{facets.number(side, two_g), facets.tensor(side, tensors.stresses),
                          facets.tensor(side, tensors.gradients)});
  });
  return pull;
}

}  // namespace muckpile
