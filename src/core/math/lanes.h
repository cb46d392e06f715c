// SPDX-License-Identifier: GPL-2.0-or-later
// Numbers, or vectors, worked on at once: the points of a facet, or facets, blocks and contacts
// side by side. Scope: arithmetic for the inner loops of src/core.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <experimental/simd>
#include <type_traits>
#if defined(__AVX2__)
#include <immintrin.h>
#endif

#include "math/types.h"

namespace muckpile {

inline constexpr int kLanes = 4;

/// Numbers that the processor this is built for works on with one instruction: 8 with AVX-512, 4
/// with AVX2. The passes over facets, blocks and contacts take as many at once: vectors of two
/// registers go through memory (GCC 12), up to three times slower.
inline constexpr std::size_t kNativeLanes = std::experimental::native_simd<double>::size();

/// One number per lane (std::simd of the Parallelism TS 2).
using Lanes =
    std::experimental::simd<double, std::experimental::simd_abi::deduce_t<double, kLanes>>;
using LaneMask = Lanes::mask_type;

template <class T>
[[nodiscard]] Lanes load(const std::array<T, kLanes>& values) {
  return {values.data(), std::experimental::element_aligned};
}
/// Where `mask` holds `yes`, elsewhere `no`.
template <class Number>
[[nodiscard, gnu::always_inline]] inline Number choose(const typename Number::mask_type& mask,
                                                       const Number& yes,
                                                       std::type_identity_t<Number> no) {
  where(mask, no) = yes;
  return no;
}
/// Of one number, for laws that are written for lanes.
[[nodiscard]] inline double choose(bool mask, double yes, double no) { return mask ? yes : no; }
/// Of so many lanes, bit per lane.
template <class Number>
[[nodiscard, gnu::always_inline]] inline typename Number::mask_type mask_of(unsigned lanes) {
#if defined(__AVX512F__)
  if constexpr (sizeof(Number) == sizeof(__m512d))  // GCC 12 branches for every lane
    return Number(_mm512_maskz_mov_pd(static_cast<__mmask8>(lanes), _mm512_set1_pd(1.0))) > 0.0;
#elif defined(__AVX2__)
  if constexpr (sizeof(Number) == sizeof(__m256d)) {
    const __m256i own = _mm256_setr_epi64x(1, 2, 4, 8), all = _mm256_set1_epi64x(lanes);
    const __m256i in = _mm256_cmpeq_epi64(_mm256_and_si256(all, own), own);
    return Number(_mm256_and_pd(_mm256_castsi256_pd(in), _mm256_set1_pd(1.0))) > 0.0;
  }
#endif
  return Number([&](auto lane) { return (lanes >> lane & 1u) != 0 ? 1.0 : 0.0; }) > 0.0;
}
/// Those of so many lanes, bit per lane, one behind the other.
template <class Number>
[[gnu::always_inline]] inline void store_lanes(const Number& v, unsigned lanes, double* to) {
#if defined(__AVX512F__)
  if constexpr (sizeof(Number) == sizeof(__m512d)) {
    const __m512d packed =
        _mm512_maskz_compress_pd(static_cast<__mmask8>(lanes), static_cast<__m512d>(v));
    const unsigned first = (1u << std::popcount(lanes)) - 1u;
    return _mm512_mask_storeu_pd(to, static_cast<__mmask8>(first), packed);
  }
#endif
  for (std::size_t k = 0; k < Number::size(); ++k)
    if ((lanes >> k & 1u) != 0) *to++ = v[k];
}
/// Bit per lane of a mask of Number.
template <class Number>
[[nodiscard, gnu::always_inline]] inline unsigned bits_of(const typename Number::mask_type& mask) {
#if defined(__AVX2__)
  if constexpr (sizeof(Number) == sizeof(__m256d)) {  // GCC 12 cannot make a register of the mask
    const Number signs = choose(mask, Number(-1.0), 0.0);
    return static_cast<unsigned>(_mm256_movemask_pd(static_cast<__m256d>(signs)));
  }
#endif
  unsigned lanes = 0;
  for (std::size_t k = 0; k < Number::size(); ++k) lanes |= (mask[k] ? 1u : 0u) << k;
  return lanes;
}
/// 1 / sqrt(x) to a few units of the last place, of x >= 0; finite at 0. Two of Newton's steps
/// after the processor's first guess: a third of the time of its root and its division.
template <class Number>
[[nodiscard, gnu::always_inline]] inline Number inverse_root(const Number& x) {
  constexpr double kLeast = 1e-200;
  const Number safe = max(x, Number(kLeast));
#if defined(__AVX512F__)
  if constexpr (sizeof(Number) == sizeof(__m512d)) {
    Number guess(_mm512_maskz_rsqrt14_pd(0xFF, static_cast<__m512d>(safe)));
    for (int k = 0; k < 2; ++k) guess = guess * (1.5 - 0.5 * safe * guess * guess);
    return guess;
  }
#endif
  return 1.0 / sqrt(safe);
}
/// As exact as inverse_root(); 0 at 0.
template <class Number>
[[nodiscard, gnu::always_inline]] inline Number root(const Number& x) {
  return x * inverse_root(x);
}
[[nodiscard]] inline double sum(const Lanes& v) { return (v[0] + v[1]) + (v[2] + v[3]); }

/// One vector per lane of Number, a simd type.
template <class Number>
struct VectorOf {
  Number x = 0.0, y = 0.0, z = 0.0;

  VectorOf() = default;
  VectorOf(const Number& ax, const Number& ay, const Number& az) : x(ax), y(ay), z(az) {}
  explicit VectorOf(const Vec3& same) : x(same.x()), y(same.y()), z(same.z()) {}
  [[nodiscard]] Vec3 at(int lane) const {
    const auto k = static_cast<std::size_t>(lane);
    return {x[k], y[k], z[k]};
  }
  VectorOf& operator+=(const VectorOf& o) { return *this = VectorOf(x + o.x, y + o.y, z + o.z); }
};

using LaneVec = VectorOf<Lanes>;

template <class Number>
[[nodiscard, gnu::always_inline]] inline VectorOf<Number> operator+(const VectorOf<Number>& a,
                                                                    const VectorOf<Number>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class Number>
[[nodiscard, gnu::always_inline]] inline VectorOf<Number> operator-(const VectorOf<Number>& a,
                                                                    const VectorOf<Number>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class Number>
[[nodiscard, gnu::always_inline]] inline VectorOf<Number> operator*(const Number& s,
                                                                    const VectorOf<Number>& v) {
  return {s * v.x, s * v.y, s * v.z};
}
template <class Number>
[[nodiscard, gnu::always_inline]] inline Number dot(const VectorOf<Number>& a,
                                                    const VectorOf<Number>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class Number>
[[nodiscard, gnu::always_inline]] inline VectorOf<Number> cross(const VectorOf<Number>& a,
                                                                const VectorOf<Number>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// One matrix per lane.
template <class Number>
struct MatrixOf {
  VectorOf<Number> x, y, z;  // columns

  [[gnu::always_inline]] VectorOf<Number> operator*(const VectorOf<Number>& v) const {
    return v.x * x + v.y * y + v.z * z;
  }
  /// Of the transposed matrix.
  [[gnu::always_inline]] VectorOf<Number> back(const VectorOf<Number>& v) const {
    return {dot(x, v), dot(y, v), dot(z, v)};
  }
};

[[nodiscard]] inline LaneVec rotated(const Mat3& r, const LaneVec& v) {
  return {r(0, 0) * v.x + r(0, 1) * v.y + r(0, 2) * v.z,
          r(1, 0) * v.x + r(1, 1) * v.y + r(1, 2) * v.z,
          r(2, 0) * v.x + r(2, 1) * v.y + r(2, 2) * v.z};
}
/// Rotated by the inverse of `r`.
[[nodiscard]] inline LaneVec rotated_back(const Mat3& r, const LaneVec& v) {
  return {r(0, 0) * v.x + r(1, 0) * v.y + r(2, 0) * v.z,
          r(0, 1) * v.x + r(1, 1) * v.y + r(2, 1) * v.z,
          r(0, 2) * v.x + r(1, 2) * v.y + r(2, 2) * v.z};
}
template <class Number>
[[nodiscard, gnu::always_inline]] inline VectorOf<Number> choose(
    const typename Number::mask_type& mask, const VectorOf<Number>& yes,
    const VectorOf<Number>& no) {
  return {choose(mask, yes.x, no.x), choose(mask, yes.y, no.y), choose(mask, yes.z, no.z)};
}
[[nodiscard]] inline Vec3 sum(const LaneVec& v) { return {sum(v.x), sum(v.y), sum(v.z)}; }

}  // namespace muckpile
