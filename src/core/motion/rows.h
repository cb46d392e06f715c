// SPDX-License-Identifier: GPL-2.0-or-later
// Rows of three or four numbers per body or sphere, and the same numbers in lanes.
// Scope: some bodies at once (one per lane), or one sphere (its three numbers in four lanes).
#pragma once

#include <array>
#include <cstddef>
#include <experimental/simd>
#if defined(__AVX2__)
#include <immintrin.h>
#endif

#include "math/lanes.h"
#include "math/transpose.h"

namespace muckpile {

inline constexpr std::size_t kBodyLanes = kNativeLanes;
using BodyLanes =
    std::experimental::simd<double, std::experimental::simd_abi::deduce_t<double, kBodyLanes>>;
using BodyVectors = VectorOf<BodyLanes>;

#if defined(__AVX512F__)
namespace rows_detail {
/// Without a mask GCC 12 takes these intrinsics for uninitialized (GCC bug 105593).
inline constexpr __mmask8 kAll = 0xFF;
[[gnu::always_inline]] inline __m512d pick(__m512d a, __m512d b, __m512i places) {
  return _mm512_permutex2var_pd(a, places, b);
}
[[gnu::always_inline]] inline __m512d eight(const BodyLanes& lanes) {
  return static_cast<__m512d>(lanes);
}
}  // namespace rows_detail
#endif

/// A row of three numbers for each lane, one behind the other.
[[nodiscard, gnu::always_inline]] inline BodyVectors load_threes(const double* from) {
#if defined(__AVX512F__)
  if constexpr (sizeof(BodyLanes) == sizeof(__m512d)) {
    using rows_detail::pick;
    const __m512d a = _mm512_loadu_pd(from), b = _mm512_loadu_pd(from + 8),
                  c = _mm512_loadu_pd(from + 16);
    // Places 0 to 7 are those of the first, 8 to 15 those of the second; where the second pick puts
    // a number of c, the first may put anything.
    const __m512d x = pick(a, b, _mm512_setr_epi64(0, 3, 6, 9, 12, 15, 0, 0));
    const __m512d y = pick(a, b, _mm512_setr_epi64(1, 4, 7, 10, 13, 0, 0, 0));
    const __m512d z = pick(a, b, _mm512_setr_epi64(2, 5, 8, 11, 14, 0, 0, 0));
    return {BodyLanes(pick(x, c, _mm512_setr_epi64(0, 1, 2, 3, 4, 5, 10, 13))),
            BodyLanes(pick(y, c, _mm512_setr_epi64(0, 1, 2, 3, 4, 8, 11, 14))),
            BodyLanes(pick(z, c, _mm512_setr_epi64(0, 1, 2, 3, 4, 9, 12, 15)))};
  }
#elif defined(__AVX2__)
  if constexpr (sizeof(BodyLanes) == sizeof(__m256d)) {
    const auto pairs = [from](std::size_t k) {
      return _mm256_loadu2_m128d(from + k + 6, from + k);
    };
    const __m256d xy = pairs(0), zx = pairs(2), yz = pairs(4);
    return {BodyLanes(_mm256_blend_pd(xy, zx, 0b1010)),
            BodyLanes(_mm256_shuffle_pd(xy, yz, 0b0101)),
            BodyLanes(_mm256_blend_pd(zx, yz, 0b1010))};
  }
#endif
  const auto each = [from](std::size_t d) {
    return BodyLanes([=](auto lane) { return from[3 * lane + d]; });
  };
  return {each(0), each(1), each(2)};
}

/// As load_threes() reads them.
[[gnu::always_inline]] inline void store_threes(const BodyVectors& v, double* to) {
#if defined(__AVX512F__)
  if constexpr (sizeof(BodyLanes) == sizeof(__m512d)) {
    using rows_detail::pick;
    const __m512d x = rows_detail::eight(v.x), y = rows_detail::eight(v.y),
                  z = rows_detail::eight(v.z);
    const __m512d a = pick(x, y, _mm512_setr_epi64(0, 8, 0, 1, 9, 0, 2, 10));
    const __m512d b = pick(x, y, _mm512_setr_epi64(0, 3, 11, 0, 4, 12, 0, 5));
    const __m512d c = pick(x, y, _mm512_setr_epi64(13, 0, 6, 14, 0, 7, 15, 0));
    _mm512_storeu_pd(to, pick(a, z, _mm512_setr_epi64(0, 1, 8, 3, 4, 9, 6, 7)));
    _mm512_storeu_pd(to + 8, pick(b, z, _mm512_setr_epi64(10, 1, 2, 11, 4, 5, 12, 7)));
    _mm512_storeu_pd(to + 16, pick(c, z, _mm512_setr_epi64(0, 13, 2, 3, 14, 5, 6, 15)));
    return;
  }
#elif defined(__AVX2__)
  if constexpr (sizeof(BodyLanes) == sizeof(__m256d)) {
    const auto x = static_cast<__m256d>(v.x), y = static_cast<__m256d>(v.y),
               z = static_cast<__m256d>(v.z);
    _mm256_storeu2_m128d(to + 6, to, _mm256_unpacklo_pd(x, y));
    _mm256_storeu2_m128d(to + 8, to + 2, _mm256_shuffle_pd(z, x, 0b1010));
    _mm256_storeu2_m128d(to + 10, to + 4, _mm256_unpackhi_pd(y, z));
    return;
  }
#endif
  for (std::size_t k = 0; k < kBodyLanes; ++k) {
    to[3 * k] = v.x[k];
    to[3 * k + 1] = v.y[k];
    to[3 * k + 2] = v.z[k];
  }
}

/// A row of four numbers for each lane, one behind the other.
[[nodiscard, gnu::always_inline]] inline std::array<BodyLanes, 4> load_fours(const double* from) {
#if defined(__AVX512F__)
  if constexpr (sizeof(BodyLanes) == sizeof(__m512d)) {
    using rows_detail::kAll;
    const auto rows = [from](std::size_t k) {  // k and k + 2
      return _mm512_maskz_insertf64x4(kAll, _mm512_castpd256_pd512(_mm256_loadu_pd(from + 4 * k)),
                                      _mm256_loadu_pd(from + 4 * (k + 2)), 1);
    };
    const __m512d a = rows(0), b = rows(1), c = rows(4), d = rows(5);
    const __m512d first_02 = _mm512_maskz_unpacklo_pd(kAll, a, b),
                  last_02 = _mm512_maskz_unpacklo_pd(kAll, c, d);
    const __m512d first_13 = _mm512_maskz_unpackhi_pd(kAll, a, b),
                  last_13 = _mm512_maskz_unpackhi_pd(kAll, c, d);
    return {BodyLanes(_mm512_maskz_shuffle_f64x2(kAll, first_02, last_02, 0x88)),
            BodyLanes(_mm512_maskz_shuffle_f64x2(kAll, first_13, last_13, 0x88)),
            BodyLanes(_mm512_maskz_shuffle_f64x2(kAll, first_02, last_02, 0xDD)),
            BodyLanes(_mm512_maskz_shuffle_f64x2(kAll, first_13, last_13, 0xDD))};
  }
#elif defined(__AVX2__)
  if constexpr (sizeof(BodyLanes) == sizeof(__m256d)) {
    const auto row = [from](std::size_t k) { return _mm256_loadu_pd(from + 4 * k); };
    const auto [n0, n1, n2, n3] = transposed(row(0), row(1), row(2), row(3));
    return {BodyLanes(n0), BodyLanes(n1), BodyLanes(n2), BodyLanes(n3)};
  }
#endif
  const auto each = [from](std::size_t d) {
    return BodyLanes([=](auto lane) { return from[4 * lane + d]; });
  };
  return {each(0), each(1), each(2), each(3)};
}

/// As load_fours() reads them.
[[gnu::always_inline]] inline void store_fours(const std::array<BodyLanes, 4>& v, double* to) {
#if defined(__AVX512F__)
  if constexpr (sizeof(BodyLanes) == sizeof(__m512d)) {
    using rows_detail::eight;
    using rows_detail::kAll;
    using rows_detail::pick;
    const __m512i first = _mm512_setr_epi64(0, 1, 8, 9, 4, 5, 12, 13),
                  second = _mm512_setr_epi64(2, 3, 10, 11, 6, 7, 14, 15);
    const __m512d even_01 = _mm512_maskz_unpacklo_pd(kAll, eight(v[0]), eight(v[1]));
    const __m512d even_23 = _mm512_maskz_unpacklo_pd(kAll, eight(v[2]), eight(v[3]));
    const __m512d odd_01 = _mm512_maskz_unpackhi_pd(kAll, eight(v[0]), eight(v[1]));
    const __m512d odd_23 = _mm512_maskz_unpackhi_pd(kAll, eight(v[2]), eight(v[3]));
    const __m512d rows_04 = pick(even_01, even_23, first), rows_26 = pick(even_01, even_23, second);
    const __m512d rows_15 = pick(odd_01, odd_23, first), rows_37 = pick(odd_01, odd_23, second);
    _mm512_storeu_pd(to, _mm512_maskz_shuffle_f64x2(kAll, rows_04, rows_15, 0x44));
    _mm512_storeu_pd(to + 8, _mm512_maskz_shuffle_f64x2(kAll, rows_26, rows_37, 0x44));
    _mm512_storeu_pd(to + 16, _mm512_maskz_shuffle_f64x2(kAll, rows_04, rows_15, 0xEE));
    _mm512_storeu_pd(to + 24, _mm512_maskz_shuffle_f64x2(kAll, rows_26, rows_37, 0xEE));
    return;
  }
#elif defined(__AVX2__)
  if constexpr (sizeof(BodyLanes) == sizeof(__m256d)) {
    const auto column = [&v](std::size_t d) { return static_cast<__m256d>(v[d]); };
    const auto [n0, n1, n2, n3] = transposed(column(0), column(1), column(2), column(3));
    _mm256_storeu_pd(to, n0);
    _mm256_storeu_pd(to + 4, n1);
    _mm256_storeu_pd(to + 8, n2);
    _mm256_storeu_pd(to + 12, n3);
    return;
  }
#endif
  for (std::size_t k = 0; k < kBodyLanes; ++k)
    for (std::size_t d = 0; d < 4; ++d) to[4 * k + d] = v[d][k];
}

/// One row of three numbers; the fourth lane is 0.
[[nodiscard, gnu::always_inline]] inline Lanes load_three(const double* from) {
#if defined(__AVX512VL__)
  if constexpr (sizeof(Lanes) == sizeof(__m256d)) return Lanes(_mm256_maskz_loadu_pd(0x7, from));
#elif defined(__AVX2__)
  if constexpr (sizeof(Lanes) == sizeof(__m256d))
    return Lanes(_mm256_set_m128d(_mm_load_sd(from + 2), _mm_loadu_pd(from)));
#endif
  return Lanes([from](auto lane) { return lane < 3 ? from[lane] : 0.0; });
}
[[gnu::always_inline]] inline void store_three(const Lanes& v, double* to) {
#if defined(__AVX512VL__)
  if constexpr (sizeof(Lanes) == sizeof(__m256d)) {
    const auto four = static_cast<__m256d>(v);
    _mm256_mask_storeu_pd(to, 0x7, four);
    return;
  }
#elif defined(__AVX2__)  // AMD's masked store is slow
  if constexpr (sizeof(Lanes) == sizeof(__m256d)) {
    const auto four = static_cast<__m256d>(v);
    _mm_storeu_pd(to, _mm256_castpd256_pd128(four));
    _mm_store_sd(to + 2, _mm256_extractf128_pd(four, 1));
    return;
  }
#endif
  for (std::size_t d = 0; d < 3; ++d) to[d] = v[d];
}
/// y, z, x of a row.
[[nodiscard, gnu::always_inline]] inline Lanes next_axis(const Lanes& v) {
#if defined(__AVX2__)
  if constexpr (sizeof(Lanes) == sizeof(__m256d))
    return Lanes(_mm256_permute4x64_pd(static_cast<__m256d>(v), 0b11'00'10'01));
#endif
  return Lanes([&v](auto lane) { return v[lane < 3 ? (lane + 1) % 3 : 3]; });
}
/// Vector product of two rows.
[[nodiscard, gnu::always_inline]] inline Lanes cross(const Lanes& a, const Lanes& b) {
  return next_axis(a * next_axis(b) - next_axis(a) * b);
}
[[nodiscard, gnu::always_inline]] inline Lanes load_four(const double* from) {
  return {from, std::experimental::element_aligned};
}
[[gnu::always_inline]] inline void store_four(const Lanes& v, double* to) {
  v.copy_to(to, std::experimental::element_aligned);
}

}  // namespace muckpile
