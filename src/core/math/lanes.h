// SPDX-License-Identifier: GPL-2.0-or-later
// Four numbers, or four vectors, worked on at once: what is done at the integration points of a
// facet is the same for each.
// Scope: arithmetic for the inner loops of src/core; what is kept in memory is FourVectors.
#pragma once

#include <array>
#include <cstddef>
#include <experimental/simd>

#include "math/four_vectors.h"
#include "math/types.h"

namespace muckpile {

/// One number per lane (std::simd of the Parallelism TS 2).
using Lanes =
    std::experimental::simd<double, std::experimental::simd_abi::deduce_t<double, kLanes>>;
using LaneMask = Lanes::mask_type;

[[nodiscard]] inline Lanes load(const std::array<double, kLanes>& values) {
  return {values.data(), std::experimental::element_aligned};
}
/// Where `mask` holds `yes`, elsewhere `no`.
[[nodiscard]] inline Lanes choose(const LaneMask& mask, const Lanes& yes, Lanes no) {
  where(mask, no) = yes;
  return no;
}
[[nodiscard]] inline double sum(const Lanes& v) { return (v[0] + v[1]) + (v[2] + v[3]); }

/// One vector per lane.
struct LaneVec {
  Lanes x = 0.0, y = 0.0, z = 0.0;

  LaneVec() = default;
  LaneVec(const Lanes& ax, const Lanes& ay, const Lanes& az) : x(ax), y(ay), z(az) {}
  explicit LaneVec(const Vec3& same) : x(same.x()), y(same.y()), z(same.z()) {}
  explicit LaneVec(const FourVectors& v) : x(load(v.x)), y(load(v.y)), z(load(v.z)) {}

  void store(FourVectors& to) const {
    x.copy_to(to.x.data(), std::experimental::element_aligned);
    y.copy_to(to.y.data(), std::experimental::element_aligned);
    z.copy_to(to.z.data(), std::experimental::element_aligned);
  }
  [[nodiscard]] Vec3 at(int lane) const {
    const auto k = static_cast<std::size_t>(lane);
    return {x[k], y[k], z[k]};
  }
  LaneVec& operator+=(const LaneVec& o) { return *this = LaneVec(x + o.x, y + o.y, z + o.z); }
};

[[nodiscard]] inline LaneVec operator+(const LaneVec& a, const LaneVec& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
[[nodiscard]] inline LaneVec operator-(const LaneVec& a, const LaneVec& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
[[nodiscard]] inline LaneVec operator*(const Lanes& s, const LaneVec& v) {
  return {s * v.x, s * v.y, s * v.z};
}
[[nodiscard]] inline Lanes dot(const LaneVec& a, const LaneVec& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
[[nodiscard]] inline LaneVec cross(const LaneVec& a, const LaneVec& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
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
[[nodiscard]] inline LaneVec choose(const LaneMask& mask, const LaneVec& yes, const LaneVec& no) {
  return {choose(mask, yes.x, no.x), choose(mask, yes.y, no.y), choose(mask, yes.z, no.z)};
}
[[nodiscard]] inline Vec3 sum(const LaneVec& v) { return {sum(v.x), sum(v.y), sum(v.z)}; }

}  // namespace muckpile
