// SPDX-License-Identifier: GPL-2.0-or-later
// Whether two convex solids are apart, and how far along a direction that shows
// it. Scope: exact where a gap is found; solids that nearly touch may be called
// touching.
#pragma once

#include <cstdint>

#include "contact/polyhedra/solid.h"

namespace muckpile {

/// Least n.x of b's corners less greatest of a's [m]: above 0 they are apart
/// along the unit n.
[[nodiscard]] double gap_along(const PlacedSolid& a, const PlacedSolid& b, const Vec3& n);

/// The same in the axes of each: `n` those of a, `n_second` of b; `between`
/// their centres along n.
[[nodiscard]] double gap_along(const Solid& a, const Solid& b, const Vec3& n, const Vec3& n_second,
                               double between);

/// Turns `n` (unit, from a to b) until they are apart along it, as far as a few
/// steps do; gap along it [m], not above 0: none found. Each step mirrors n at
/// the line between the two corners that are in the way (Chung and Wang 1996).
[[nodiscard]] double find_gap(const PlacedSolid& a, const PlacedSolid& b, Vec3& n);

/// Per corner, bit p: outside plane p of the other solid.
using OutsideBits = std::array<std::uint64_t, Solid::kMostCorners>;

/// Of the corners of `a` against the planes of `b`. Greatest gap above a plane
/// [m], whose normal is put into `n`; not above 0: no plane keeps them apart.
/// `strictly`: what lies in a plane is outside it.
[[nodiscard]] double outside_bits(const PlacedSolid& a, const PlacedSolid& b, bool strictly,
                                  OutsideBits& bits, Vec3& n);

}  // namespace muckpile
