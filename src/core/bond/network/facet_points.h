// SPDX-License-Identifier: GPL-2.0-or-later
// The integration points of a facet, and the limits up to which a broken facet is a plane contact.
// Scope: constants and masks. Three points, the first kFacetPoints lanes of four; the last lane has
// no meaning. Lengths in radii of the circle of the facet's area, angles in radians.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "bond/network/facet_group.h"
#include "bond/network/facet_memory.h"
#include "math/lanes.h"

namespace muckpile {

static_assert(kFacetPoints == kLanes - 1);

/// Where the points lie: three points at 120 degrees on the ellipse of half axes sqrt(2) x gyration
/// radii have the facet's second moments. Weights of the first and the second half axis.
inline constexpr double kHalfSqrt3 = 0.86602540378443865;
inline constexpr std::array<double, kLanes> kOnFirst = {1.0, -0.5, -0.5, 0.0};
inline constexpr std::array<double, kLanes> kOnSecond = {0.0, kHalfSqrt3, -kHalfSqrt3, 0.0};

[[nodiscard]] inline LaneMask is_point() {
  return Lanes([](auto lane) { return lane < kFacetPoints ? 1.0 : 0.0; }) > 0.5;
}

/// Points for which `is` holds.
template <class Is>
[[nodiscard]] LaneMask where(const Is& is) {
  const auto value = [&](auto lane) {
    return lane < kFacetPoints && is(std::size_t{lane % kFacetPoints}) ? 1.0 : 0.0;
  };
  return Lanes(value) > 0.5;
}
[[nodiscard]] inline LaneMask where_broken(const FacetTraces& memory) {
  return where([&](std::size_t p) { return memory.broken[p]; });
}
[[nodiscard]] inline LaneMask where_contact(const FacetTraces& memory) {
  return where([&](std::size_t p) { return memory.is_contact(p); });
}
[[nodiscard]] inline LaneMask where_slipping(const FacetTraces& memory) {
  return where([&](std::size_t p) { return memory.slipping[p]; });
}

/// Mean over the points.
[[nodiscard]] inline Vec3 mean_at_points(const LaneVec& v) {
  return sum(choose(is_point(), Lanes(1.0 / kFacetPoints), 0.0) * v);
}

/// A vector of each point.
[[nodiscard]] inline LaneVec lanes_of(const std::array<Vec3, kFacetPoints>& v) {
  const auto of = [&](Eigen::Index d) {
    return Lanes([&](auto lane) { return lane < kFacetPoints ? v[lane % kFacetPoints][d] : 0.0; });
  };
  return {of(0), of(1), of(2)};
}

/// A facet that has turned so far begins to fade, and does not hold on by a last point, as by a
/// hinge [rad].
inline constexpr double kTurnStart = 0.1;

// A broken facet is a plane contact only while its two faces still match. It fades between these
// shares of its radius slid, and of radians turned, and retires once it has opened by kOpened and
// beyond where it broke.
inline constexpr double kSlideStart = 0.1, kSlideEnd = 0.5;
inline constexpr double kTurnEnd = 0.5;  // from kTurnStart
inline constexpr double kOpened = 0.1;
inline constexpr double kSurelyOpen = 0.01;  // least margin beyond what its rotation explains

/// How far the faces match: 1 to 0. `slid` in radii, `turned` in radians.
[[nodiscard]] inline double matching_faces(double slid, double turned) {
  const auto ramp_down = [](double x, double start, double end) {
    return std::clamp((end - x) / (end - start), 0.0, 1.0);
  };
  return ramp_down(slid, kSlideStart, kSlideEnd) * ramp_down(turned, kTurnStart, kTurnEnd);
}

}  // namespace muckpile
