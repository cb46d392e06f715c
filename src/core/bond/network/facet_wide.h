// SPDX-License-Identifier: GPL-2.0-or-later
// How the two sides of facets lie in the present pose, the facets of a group at once: one per lane.
// Scope: reads a group and the states of blocks; SI units. A facet takes this path or that by its
// own state alone, never by those beside it in its group, and blocks get their parts in the order
// of the facets: both are the same on any ranks.
#pragma once

#include <array>
#include <experimental/simd>
#if defined(__AVX2__)
#include <immintrin.h>
#endif

#include "bond/network/facet_group.h"
#include "bond/network/facet_parting.h"
#include "bond/network/facet_points.h"
#include "bond/network/network_block.h"
#include "math/lanes.h"
#include "math/transpose.h"

namespace muckpile {

using Wide = std::experimental::simd<double, std::experimental::simd_abi::deduce_t<double, kGroup>>;
using WideMask = Wide::mask_type;
using WideVec = VectorOf<Wide>;
using WideMat = MatrixOf<Wide>;

template <class T>
[[gnu::always_inline]] inline Wide wide(const FacetRow<T>& row) {
  return {row.data(), std::experimental::element_aligned};
}
template <class T>
[[gnu::always_inline]] inline WideVec wide(const FacetRows<T>& rows) {
  return {wide(rows[0]), wide(rows[1]), wide(rows[2])};
}
[[gnu::always_inline]] inline void store(const Wide& v, FacetRow<double>& to) {
  v.copy_to(to.data(), std::experimental::element_aligned);
}
[[gnu::always_inline]] inline void store(const WideVec& v, FacetRows<double>& to) {
  store(v.x, to[0]);
  store(v.y, to[1]);
  store(v.z, to[2]);
}

/// from[place] of each facet. GCC 12 does not make the processor's own gather of it: 10 % of a
/// pass.
[[gnu::always_inline]] inline Wide gather(const FacetRow<std::int32_t>& places,
                                          const double* from) {
#if defined(__AVX512F__) && defined(__AVX512VL__)
  if constexpr (sizeof(Wide) == sizeof(__m512d)) {
    const __m256i at = _mm256_load_si256(reinterpret_cast<const __m256i*>(places.data()));
    return Wide(_mm512_i32gather_pd(at, from, sizeof(double)));
  }
#endif
  return Wide([&](auto lane) { return from[places[lane]]; });
}

/// Mirrors, which alone have no shear: behind one the image moves as much the other way, and slides
/// along. So are lanes without a facet.
[[gnu::always_inline]] inline WideMask at_mirror(const FacetGroup& group) {
  return wide(group.shear) == 0.0;
}

/// Into `lanes` of the rows alone.
[[gnu::always_inline]] inline void store(const WideVec& v, unsigned lanes, FacetRows<double>& to) {
  const WideMask mask = mask_of<Wide>(lanes);
  store(WideVec(choose(mask, v.x, wide(to[0])), choose(mask, v.y, wide(to[1])),
                choose(mask, v.z, wide(to[2]))),
        to);
}

struct WideFour {
  Wide n0, n1, n2, n3;
  [[gnu::always_inline]] WideVec vector() const { return {n1, n2, n3}; }
};

struct WidePlace {
  WideMat rotation;
  WideVec centre;  // [m]
};

/// Where what a group's blocks have lies, one OfBlock each, in numbers after that of the first
/// block. The numbers of a block are loaded together and transposed: 5 % of all passes less than
/// with the processor's gather, which is much slower on those that guard it against snooping.
template <class OfBlock>
class PlacesOf {
 public:
  [[gnu::always_inline]] explicit PlacesOf(const FacetRow<std::int32_t>& blocks) {
    static_assert(sizeof(OfBlock) % sizeof(double) == 0);
    constexpr int kNumbers = sizeof(OfBlock) / sizeof(double);
    for (std::size_t k = 0; k < kGroup; ++k) at_[k] = kNumbers * blocks[k];
  }
  /// `first` is that of the first block. A number before the vector is read as well.
  [[gnu::always_inline]] WideVec vector(const Vec3& first) const {
    return rows_of_four(first.data() - 1).vector();
  }
  [[gnu::always_inline]] WideMat matrix(const Mat3& first) const {
    const double* from = first.data();
    const WideFour a = rows_of_four(from), b = rows_of_four(from + 4),
                   last = rows_of_four(from + 5);
    return {{a.n0, a.n1, a.n2}, {a.n3, b.n0, b.n1}, {b.n2, b.n3, last.n3}};
  }
  [[gnu::always_inline]] WidePlace place(const BlockState& first) const;

 private:
#if defined(__AVX512F__) && defined(__AVX512VL__)
  static_assert(sizeof(Wide) == sizeof(__m512d));
  [[gnu::always_inline]] static __m512d low(__m512d a, __m512d b) {
    return _mm512_shuffle_f64x2(a, b, 0x44);
  }
  [[gnu::always_inline]] static __m512d high(__m512d a, __m512d b) {
    return _mm512_shuffle_f64x2(a, b, 0xEE);
  }
  [[gnu::always_inline]] static Wide even(__m512d a, __m512d b) {
    return Wide(_mm512_shuffle_f64x2(a, b, 0x88));
  }
  [[gnu::always_inline]] static Wide odd(__m512d a, __m512d b) {
    return Wide(_mm512_shuffle_f64x2(a, b, 0xDD));
  }
  /// Four numbers of block k, and four of the next but one.
  [[gnu::always_inline]] __m512d fours(const double* from, std::size_t k) const {
    return _mm512_insertf64x4(_mm512_castpd256_pd512(_mm256_loadu_pd(from + at_[k])),
                              _mm256_loadu_pd(from + at_[k + 2]), 1);
  }
  [[gnu::always_inline]] WideFour rows_of_four(const double* from) const {
    const __m512d a = fours(from, 0), b = fours(from, 1), c = fours(from, 4), d = fours(from, 5);
    const __m512d n02 = _mm512_unpacklo_pd(a, b), more_n02 = _mm512_unpacklo_pd(c, d);
    const __m512d n13 = _mm512_unpackhi_pd(a, b), more_n13 = _mm512_unpackhi_pd(c, d);
    return {even(n02, more_n02), even(n13, more_n13), odd(n02, more_n02), odd(n13, more_n13)};
  }
#elif defined(__AVX2__) && !defined(__AVX512F__)
  static_assert(sizeof(Wide) == sizeof(__m256d));
  [[gnu::always_inline]] WideFour rows_of_four(const double* from) const {
    const auto row = [&](std::size_t k) { return _mm256_loadu_pd(from + at_[k]); };
    const auto [n0, n1, n2, n3] = transposed(row(0), row(1), row(2), row(3));
    return {Wide(n0), Wide(n1), Wide(n2), Wide(n3)};
  }
#else
  [[gnu::always_inline]] WideFour rows_of_four(const double* from) const {
    return {gather(at_, from), gather(at_, from + 1), gather(at_, from + 2), gather(at_, from + 3)};
  }
#endif
  alignas(64) FacetRow<std::int32_t> at_;
};

using BlockPlaces = PlacesOf<BlockState>;

template <class OfBlock>
[[gnu::always_inline]] inline WidePlace PlacesOf<OfBlock>::place(const BlockState& first) const {
  static_assert(offsetof(BlockState, centre) == 9 * sizeof(double));
  const double* from = first.rotation.data();
#if defined(__AVX512F__) && defined(__AVX512VL__)
  // Numbers 0, 2, 4, 6 and 1, 3, 5, 7 of pairs; std::array would drop the alignment.
  __m512d first_of[kGroup / 2], second_of[kGroup / 2];
  for (std::size_t k = 0; k < kGroup; k += 2) {
    const __m512d a = _mm512_loadu_pd(from + at_[k]), b = _mm512_loadu_pd(from + at_[k + 1]);
    first_of[k / 2] = _mm512_unpacklo_pd(a, b);
    second_of[k / 2] = _mm512_unpackhi_pd(a, b);
  }
  const __m512d n02 = low(first_of[0], first_of[1]), more_n02 = low(first_of[2], first_of[3]);
  const __m512d n46 = high(first_of[0], first_of[1]), more_n46 = high(first_of[2], first_of[3]);
  const __m512d n13 = low(second_of[0], second_of[1]), more_n13 = low(second_of[2], second_of[3]);
  const __m512d n57 = high(second_of[0], second_of[1]), more_n57 = high(second_of[2], second_of[3]);
  const WideFour last = rows_of_four(from + 8);
  return {{{even(n02, more_n02), even(n13, more_n13), odd(n02, more_n02)},
           {odd(n13, more_n13), even(n46, more_n46), even(n57, more_n57)},
           {odd(n46, more_n46), odd(n57, more_n57), last.n0}},
          last.vector()};
#else
  const WideFour a = rows_of_four(from), b = rows_of_four(from + 4), c = rows_of_four(from + 8);
  return {{{a.n0, a.n1, a.n2}, {a.n3, b.n0, b.n1}, {b.n2, b.n3, c.n0}}, c.vector()};
#endif
}

/// How the two sides of each facet of a group lie now.
struct WidePose {
  WideMat sum, difference;  // of the rotations of i and j; of j less that of i
  WideVec between;          // centre of j less that of i [m]
  WideVec near, jump;       // centroid from the centre of i; from the side of i to that of j [m]
  WideVec normal;           // unit, mean of both sides
  Wide scale;               // that makes the sum of the normals of both sides a unit vector

  /// Midway between the two sides, from the centre of block i [m].
  [[nodiscard, gnu::always_inline]] WideVec arm() const { return near + Wide(0.5) * jump; }
};

/// A number that is linear over each facet: its mean, and what it gains along the half axes.
struct WideField {
  WideVec mean, along_1, along_2;

  [[nodiscard, gnu::always_inline]] WideVec at(std::size_t p) const {
    return mean + Wide(kOnFirst[p]) * along_1 + Wide(kOnSecond[p]) * along_2;
  }
};

/// `first`: the state of the first block.
[[gnu::always_inline]] inline WidePose pose_of(const FacetGroup& group, const BlockState& first) {
  const BlockPlaces at_i(group.i), at_j(group.j);
  const auto [ri, centre_i] = at_i.place(first);
  const auto [rj, centre_j] = at_j.place(first);
  WidePose pose;
  pose.sum = {ri.x + rj.x, ri.y + rj.y, ri.z + rj.z};
  pose.difference = {rj.x - ri.x, rj.y - ri.y, rj.z - ri.z};
  pose.between = centre_j - centre_i;
  pose.near = ri * wide(group.arm);
  pose.jump = rj * wide(group.arm_j) - pose.near + pose.between;
  const WideVec both = pose.sum * wide(group.normal);
  pose.scale = 1.0 / sqrt(dot(both, both));
  pose.normal = pose.scale * both;
  return pose;
}

/// Of the points, from the side of i to that of j [m].
[[gnu::always_inline]] inline WideField jump_of(const FacetGroup& group, const WidePose& pose) {
  return {pose.jump, pose.difference * wide(group.half_1), pose.difference * wide(group.half_2)};
}

/// `first`: the state of the first block. Motion of block j's side against block i's [m/s].
[[gnu::always_inline]] inline WideField rate_of(const FacetGroup& group, const WidePose& pose,
                                                const BlockState& first) {
  const BlockPlaces at_i(group.i), at_j(group.j);
  const WideVec spin_j = at_j.vector(first.spin), spin = spin_j - at_i.vector(first.spin);
  const WideVec slip = at_j.vector(first.velocity) - at_i.vector(first.velocity);
  const Wide half(0.5);
  return {slip - cross(spin_j, pose.between) + cross(spin, pose.arm()),
          half * cross(spin, pose.sum * wide(group.half_1)),
          half * cross(spin, pose.sum * wide(group.half_2))};
}

[[gnu::always_inline]] inline FacetTurn<Wide> turn_of(const FacetGroup& group,
                                                      const WidePose& pose) {
  const WideVec half_1 = wide(group.half_1), half_2 = wide(group.half_2);
  const WideVec apart_1 = pose.difference * half_1, apart_2 = pose.difference * half_2;
  return {dot(apart_1, apart_1), dot(apart_2, apart_2), dot(half_1, half_1), dot(half_2, half_2)};
}

[[gnu::always_inline]] inline FacetParting<Wide> parting_of(const FacetGroup& group,
                                                            const WidePose& pose) {
  const Wide opened = dot(pose.normal, pose.jump);
  return {opened, across_squared(dot(pose.jump, pose.jump), opened), M_1_PI * wide(group.area),
          turn_of(group, pose)};
}

/// `force` and `moment` are those on block i, `between` leads from its centre to that of block j.
[[gnu::always_inline]] inline void store(const WideVec& force, const WideVec& moment,
                                         const WideVec& between, WideForces& forces) {
  store(force, forces.force);
  store(moment, forces.torque_i);
  store(cross(between, force) - moment, forces.torque_j);
}

/// Adds those of lane k to its two blocks.
[[gnu::always_inline]] inline void add_forces(const FacetGroup& group, std::size_t k,
                                              const WideForces& forces, std::vector<Vec3>& force,
                                              std::vector<Vec3>& torque) {
  const auto i = static_cast<std::size_t>(group.i[k]), j = static_cast<std::size_t>(group.j[k]);
  const Vec3 on_i = at_lane(forces.force, k);
  force[i] += on_i;
  torque[i] += at_lane(forces.torque_i, k);
  force[j] -= on_i;
  torque[j] += at_lane(forces.torque_j, k);
}

}  // namespace muckpile
