// SPDX-License-Identifier: GPL-2.0-or-later
// Cracks that hang together with a hole: broken joints that meet along edges, from the wall of its
// crushed zone on, and how far they reach to each side.
// Scope: where the faces were before the blast; a face that touches another in a corner only does
// not go on with its crack.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "io/charges.h"
#include "measure/joint_faces.h"

namespace muckpile {

// Per face of the rock, the hole that its crack comes from; none: it holds, or its crack begins at
// no hole. A crack between several holes is part by part that of the nearest of them. `broken` is
// not asked of faces without a block behind.
std::vector<std::optional<size_t>> crack_holes(const std::vector<RockFace>& faces,
                                               const std::vector<char>& broken,
                                               const std::vector<Charge>& charges);

inline constexpr size_t kDirections = 36;  // of equal width around the axis of a hole
inline constexpr size_t kSections = 10;    // across it, evenly along the charge

// In each direction of each section, at [section * kDirections + direction], the distance of the
// farthest point of a crack of the hole from its axis [m]: the radius of the crushed zone where
// there is none, NaN where the section meets no joint of the model. Directions are by the angle
// around the axis from x (an axis along x: from y) towards y.
using Reaches = std::array<double, kSections * kDirections>;
Reaches crack_reaches(const std::vector<RockFace>& faces,
                      const std::vector<std::optional<size_t>>& crack_holes, const Charge& charge,
                      size_t hole);

// The reach that is exceeded in a share of the directions of all sections and holes, linear between
// those in order [m]; share 0: the farthest. NaN where there is none.
double reach_exceeded(const std::vector<Reaches>& holes, double share);

// Share of these directions in which cracks reach farther than a distance [m].
double directions_beyond(const std::vector<Reaches>& holes, double distance);

}  // namespace muckpile
