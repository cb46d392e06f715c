// SPDX-License-Identifier: GPL-2.0-or-later
// A set of natural joints by its statistics, and random planes that have them.
// Scope: joints that run through a box as planes, or as discs in such planes; the same numbers give
// the same planes on every number of ranks, and to rounding on every machine.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "bond/build/joint_plane.h"

namespace muckpile {

struct NaturalJointSet {
  Vec3 normal = Vec3::UnitZ();  ///< mean of the set, of any length but 0
  double spacing = 1.0;         ///< mean distance of neighbouring planes [m]
  /// Neighbours that are parallel are no nearer than this [m]. What lies beyond it has an exponential distribution; 0
  /// gives a Poisson process, `spacing` equal distances.
  double least_spacing = 0.0;
  std::uint8_t joint_class = 1;  ///< see Facet
  double persistence = 1.0;      ///< share of each plane's area that is joint, in discs
  double radius = std::numeric_limits<double>::infinity();  ///< of the discs [m]
  /// Constant K of Fisher's distribution of the normals (Fisher 1953); infinite: all parallel.
  double concentration = std::numeric_limits<double>::infinity();
};

/// Most planes of the set that a box can hold, on average: its diagonal over the spacing.
[[nodiscard]] double most_planes(const NaturalJointSet& set, const Vec3& lo, const Vec3& hi);

/// Most discs of the set that a box can hold, on average; 0 without discs. Falls with the radius.
[[nodiscard]] double most_discs(const NaturalJointSet& set, const Vec3& lo, const Vec3& hi);

/// The least radius with which most_discs() is at most `discs`; infinite where none is large enough
/// [m].
[[nodiscard]] double least_radius(const NaturalJointSet& set, const Vec3& lo, const Vec3& hi,
                                  double discs);

/// The planes that meet the box, in the order of their signed distances from its middle. Their mean
/// area per volume of the box (P32) is persistence / spacing, whatever the scatter of the normals.
[[nodiscard]] std::vector<JointPlane> planes_of(const NaturalJointSet& set, const Vec3& lo,
                                                const Vec3& hi, std::uint64_t seed);

}  // namespace muckpile
