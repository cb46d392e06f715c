// SPDX-License-Identifier: GPL-2.0-or-later
// Whether two convex solids are apart, and how far along a direction that shows
// it. Scope: exact where a gap is found; solids that nearly touch may be called
// touching.
#pragma once

#include <cstdint>

#include "contact/polyhedra/solid.h"

namespace muckpile {

/// Where a solid's corners lie along a direction.
struct AlongDirection {
  alignas(64) std::array<double, Solid::kMostCorners> at;  ///< of each corner, with the repeats [m]
  double low, high;                                        ///< of them all [m]

  void look(const PlacedSolid& s, const Vec3& n);
  /// Planes that have a corner above this height, or at it.
  [[nodiscard]] std::uint64_t planes_above(const PlacedSolid& s, double height) const;
  [[nodiscard]] std::uint64_t planes_below(const PlacedSolid& s, double height) const;
};

/// Per corner, bit p: outside the placed plane p of the other solid.
using OutsideBits = std::array<std::uint64_t, Solid::kMostCorners>;

/// Of the corners of `a`. `strictly`: what lies in a plane is outside it.
void mark_outside(const PlacedSolid& a, const PlacedSolid& b, bool strictly, OutsideBits& bits);

/// Greatest gap [m] of the corners of `a` above a placed plane of `b`, whose normal is put into
/// `n`; not above 0: none of these planes keeps them apart.
[[nodiscard]] double gap_above_planes(const PlacedSolid& a, const PlacedSolid& b, Vec3& n);

/// Turns `n` (unit, from a to b) until they are apart along it, as far as a few
/// steps do; gap along it [m], not above 0: none found. Each step mirrors n at
/// the line between the two corners that are in the way (Chung and Wang 1996).
[[nodiscard]] double find_gap(const PlacedSolid& a, const PlacedSolid& b, Vec3& n);

}  // namespace muckpile
