// SPDX-License-Identifier: GPL-2.0-or-later
// Outlines of up to eight corners, a corner per lane: cut by planes, integrals of a strain over
// them. Scope: processors with AVX-512; elsewhere, and where there are more corners,
// OverlapFinder takes one corner after the other.
#pragma once

#include <bit>
#include <cstdint>
#include <span>

#include "math/lanes.h"

namespace muckpile {

#if defined(__AVX512F__) && defined(__AVX512VL__)
inline constexpr bool kLaneOutlines = true;
#else
inline constexpr bool kLaneOutlines = false;
#endif

using OutlineLanes = std::experimental::native_simd<double>;
using OutlineVec = VectorOf<OutlineLanes>;

/// Integrals over triangles of pressed outlines, in lanes that are still to be summed.
struct LaneSums {
  OutlineLanes pressed = 0.0;                      ///< of the strain [m2]
  OutlineVec pressed_at;                           ///< of the strain times place [m3]
  OutlineVec square, mixed;                        ///< of strain times xx, yy, zz; xy, yz, zx [m4]
  OutlineLanes weight = 0.0, weight_square = 0.0;  ///< of stiffness; times place squared
  OutlineVec weight_at;
  OutlineLanes largest_strain = 0.0;

  void add(const LaneSums& o) {
    pressed += o.pressed;
    pressed_at += o.pressed_at;
    square += o.square;
    mixed += o.mixed;
    weight += o.weight;
    weight_square += o.weight_square;
    weight_at += o.weight_at;
    largest_strain = max(largest_strain, o.largest_strain);
  }
};

class LaneOutline;

#if defined(__AVX512F__) && defined(__AVX512VL__)

/// Corners, counter-clockwise, in the first lanes; the others hold anything.
class LaneOutline {
 public:
  static constexpr int kMost = 8;
  static_assert(OutlineLanes::size() == kMost);
  enum class Left { all, part, nothing, unknown };

  /// Of a list of corners [m]. Fewer than nine.
  LaneOutline(const double* x, const double* y, const double* z, std::span<const int> corners)
      : count_(static_cast<unsigned>(corners.size())) {
    const auto in = static_cast<__mmask8>(lanes());
    const __m256i index = _mm256_maskz_loadu_epi32(in, corners.data());
    const __m512d none = _mm512_setzero_pd();
    corner_ = {OutlineLanes(_mm512_mask_i32gather_pd(none, in, index, x, 8)),
               OutlineLanes(_mm512_mask_i32gather_pd(none, in, index, y, 8)),
               OutlineLanes(_mm512_mask_i32gather_pd(none, in, index, z, 8))};
  }

  [[nodiscard]] const OutlineVec& corner() const { return corner_; }
  [[nodiscard]] Vec3 start() const { return corner_.at(0); }
  /// Of the corners.
  [[nodiscard]] double least(const OutlineLanes& v) const {
    return _mm512_mask_reduce_min_pd(static_cast<__mmask8>(lanes()), raw(v));
  }
  [[nodiscard]] double most(const OutlineLanes& v) const {
    return _mm512_mask_reduce_max_pd(static_cast<__mmask8>(lanes()), raw(v));
  }

  /// Leaves what lies where `value`, linear over the outline, is not below 0, or, where `strictly`,
  /// above it. Unknown, and nothing done: rounding has left no convex outline, or there is no room.
  [[nodiscard]] Left cut(const OutlineLanes& value, bool strictly) {
    const __m512d v = raw(value), zero = _mm512_setzero_pd();
    const unsigned inside = lanes() & (strictly ? _mm512_cmp_pd_mask(v, zero, _CMP_GT_OQ)
                                                : _mm512_cmp_pd_mask(v, zero, _CMP_GE_OQ));
    if (inside == lanes()) return Left::all;
    if (inside == 0) return Left::nothing;
    const unsigned next_inside = inside >> 1 | (inside & 1u) << (count_ - 1);
    const unsigned leaves = inside & ~next_inside, enters = lanes() & next_inside & ~inside;
    const auto kept = static_cast<unsigned>(std::popcount(inside));
    if ((leaves & (leaves - 1)) != 0 || kept + 2 > kMost) return Left::unknown;
    keep(v, kept, static_cast<unsigned>(std::countr_zero(leaves)),
         static_cast<unsigned>(std::countr_zero(enters)));
    return Left::part;
  }

  /// Twice the area of its triangles about the first corner, along `normal` [m2], still in lanes.
  [[nodiscard]] OutlineLanes twice_area(const OutlineVec& normal) const {
    return twice_area(normal, triangles());
  }

  /// Adds the integrals of the strain, whose values at the corners these are.
  void press(const OutlineLanes& strain, const OutlineVec& normal, double inverse_depth,
             LaneSums& sums) const {
    const Triangles t = triangles();
    const OutlineLanes e_a = lane(strain, t.first), e_b = lane(strain, t.second),
                       e_c = lane(strain, t.third);
    const OutlineLanes area = max(0.5 * twice_area(normal, t), OutlineLanes(0.0));
    const OutlineLanes all = e_a + e_b + e_c;
    const OutlineVec sum = t.a + t.b + t.c;
    const OutlineVec pulled = e_a * t.a + e_b * t.b + e_c * t.c;
    sums.largest_strain = max(max(sums.largest_strain, e_a), max(e_b, e_c));
    sums.pressed += area / 3.0 * all;
    sums.pressed_at += (area / 12.0) * (all * sum + pulled);
    // Integrals of e x x^T and of x x^T, e linear, over the triangle.
    const OutlineLanes share = area / 60.0, more_a = all + 2.0 * e_a, more_b = all + 2.0 * e_b,
                       more_c = all + 2.0 * e_c;
    const auto product = [&](auto i, auto j) {
      return share *
             (all * i(sum) * j(sum) + i(pulled) * j(sum) + j(pulled) * i(sum) +
              more_a * i(t.a) * j(t.a) + more_b * i(t.b) * j(t.b) + more_c * i(t.c) * j(t.c));
    };
    const auto x = [](const OutlineVec& v) { return v.x; };
    const auto y = [](const OutlineVec& v) { return v.y; };
    const auto z = [](const OutlineVec& v) { return v.z; };
    sums.square += {product(x, x), product(y, y), product(z, z)};
    sums.mixed += {product(x, y), product(y, z), product(z, x)};
    const OutlineLanes weight = area * inverse_depth;
    sums.weight += weight;
    sums.weight_at += (weight / 3.0) * sum;
    sums.weight_square +=
        weight / 12.0 * (dot(t.a, t.a) + dot(t.b, t.b) + dot(t.c, t.c) + dot(sum, sum));
  }

 private:
  /// About the first corner, a triangle per lane; the others have no size.
  struct Triangles {
    __m512i first, second, third;  ///< lanes of their corners
    OutlineVec a, b, c;
  };

  static __m512d raw(const OutlineLanes& v) { return static_cast<__m512d>(v); }
  static __m512i numbers() { return _mm512_setr_epi64(0, 1, 2, 3, 4, 5, 6, 7); }
  static __m512i all(unsigned number) { return _mm512_set1_epi64(static_cast<int>(number)); }
  static OutlineLanes lane(const OutlineLanes& v, __m512i from) {
    return OutlineLanes(_mm512_maskz_permutexvar_pd(0xFF, from, raw(v)));
  }
  static OutlineVec lane(const OutlineVec& v, __m512i from) {
    return {lane(v.x, from), lane(v.y, from), lane(v.z, from)};
  }
  [[nodiscard]] unsigned lanes() const { return (1u << count_) - 1u; }

  [[nodiscard]] Triangles triangles() const {
    const auto in = static_cast<__mmask8>(lanes() >> 2);
    Triangles t{_mm512_setzero_si512(),
                _mm512_maskz_add_epi64(in, numbers(), all(1)),
                _mm512_maskz_add_epi64(in, numbers(), all(2)),
                {},
                {},
                {}};
    t.a = lane(corner_, t.first);
    t.b = lane(corner_, t.second);
    t.c = lane(corner_, t.third);
    return t;
  }
  static OutlineLanes twice_area(const OutlineVec& normal, const Triangles& t) {
    return dot(normal, cross(t.b - t.a, t.c - t.a));
  }

  /// The corners from behind `entry` on to `exit`, then where the edges behind these two are cut.
  void keep(__m512d value, unsigned kept, unsigned exit, unsigned entry) {
    const __m512i number = numbers(), count = all(count_);
    const auto last = static_cast<__mmask8>(1u << (count_ - 1));
    const __m512i next = _mm512_mask_mov_epi64(_mm512_add_epi64(number, all(1)), last, all(0));
    const OutlineLanes here(value), there = lane(OutlineLanes(value), next);
    const OutlineVec crossing = corner_ + here / (here - there) * (lane(corner_, next) - corner_);
    __m512i from = _mm512_add_epi64(number, all(entry + 1));
    from = _mm512_mask_sub_epi64(from, _mm512_cmpge_epi64_mask(from, count), from, count);
    from = _mm512_mask_mov_epi64(from, static_cast<__mmask8>(1u << kept), all(exit + kMost));
    from = _mm512_mask_mov_epi64(from, static_cast<__mmask8>(2u << kept), all(entry + kMost));
    const auto pick = [&](const OutlineLanes& corner, const OutlineLanes& cut) {
      return OutlineLanes(_mm512_permutex2var_pd(raw(corner), from, raw(cut)));
    };
    corner_ = {pick(corner_.x, crossing.x), pick(corner_.y, crossing.y),
               pick(corner_.z, crossing.z)};
    count_ = kept + 2;
  }

  OutlineVec corner_;
  unsigned count_;
};

#endif

}  // namespace muckpile
