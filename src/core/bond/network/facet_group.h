// SPDX-License-Identifier: GPL-2.0-or-later
// What the passes over bonded facets read, some facets side by side: each number of theirs lies
// in a row, so that one vector instruction works on all.
// Scope: storage. Directions and lengths of the shape are in single precision: 6e-8 of a facet's
// size, the same on both of its sides and on every rank. But the two arms fit each other to the
// last bit of a double, or a joint at rest would carry a traction.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "math/lanes.h"
#include "math/prefetch.h"
#include "math/types.h"

namespace muckpile {

inline constexpr std::size_t kGroup = kNativeLanes;       ///< facets
inline constexpr std::size_t kGroupsAhead = 32 / kGroup;  ///< by so many passes prefetch

template <class T>
using FacetRow = std::array<T, kGroup>;
template <class T>
using FacetRows = std::array<FacetRow<T>, 3>;

struct alignas(64) FacetGroup {
  FacetRow<std::int32_t> i{}, j{};  ///< blocks
  FacetRow<double> sharpening{};    ///< energy per square of the difference of the two dilatations,
                                    ///< twice; of the bonded points [J]
  FacetRow<double> area{};          ///< [m2]
  FacetRow<double> shear{}, normal_extra{};  ///< stiffness; normal less shear [Pa/m]
  FacetRow<double> bulk{};                   ///< share of each block's bulk stress in the traction
  FacetRows<double> arm_j{};                 ///< centroid from the centre of j [m]
  FacetRows<float> arm{}, half_1{}, half_2{};  ///< centroid from the centre of i; half axes [m]
  FacetRows<float> normal{};                   ///< [-]
  FacetRows<float> opening_i{}, opening_j{};   ///< m of the two blocks [-]

  /// Prefetches i, j and sharpening ahead of their use.
  void fetch_couplings() const {
    prefetch(i.data());
    if constexpr (sizeof(i) + sizeof(j) >= 64) prefetch(sharpening.data());
  }
};

/// Some facets of one group.
struct LaneSet {
  std::uint32_t group = 0;
  std::uint32_t lanes = 0;  ///< bit per facet

  [[nodiscard]] bool has(std::size_t lane) const { return (lanes >> lane & 1u) != 0; }
};

/// Calls `of` with each of `lanes`, in order.
template <class Of>
void each_lane(unsigned lanes, const Of& of) {
  for (unsigned left = lanes; left != 0; left &= left - 1)
    of(static_cast<std::size_t>(std::countr_zero(left)));
}

/// Calls `of` with the number of each facet, in order.
template <class Of>
void each_facet(const std::vector<LaneSet>& sets, const Of& of) {
  for (const LaneSet& set : sets)
    each_lane(set.lanes, [&](std::size_t k) { of(set.group * kGroup + k); });
}

/// Adds facet `f`, which is not before any that is in already.
inline void add_facet(std::vector<LaneSet>& sets, std::size_t f) {
  const auto group = static_cast<std::uint32_t>(f / kGroup);
  if (sets.empty() || sets.back().group != group) sets.push_back({group, 0});
  sets.back().lanes |= 1u << f % kGroup;
}

template <class T>
[[nodiscard]] Vec3 at_lane(const FacetRows<T>& rows, std::size_t lane) {
  return {rows[0][lane], rows[1][lane], rows[2][lane]};
}

template <class T>
void set_lane(FacetRows<T>& rows, std::size_t lane, const Vec3& value) {
  for (std::size_t d = 0; d < 3; ++d)
    rows[d][lane] = static_cast<T>(value[static_cast<Eigen::Index>(d)]);
}

/// Of a group's facets on their blocks: force and torque on i, torque on j; force on j is opposite.
struct WideForces {
  alignas(64) FacetRows<double> force, torque_i, torque_j;
  FacetRow<double> damped;  ///< taken by dashpots in the step; only where there are some [J]
};

}  // namespace muckpile
