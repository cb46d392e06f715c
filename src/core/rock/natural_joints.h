// SPDX-License-Identifier: GPL-2.0-or-later
// The natural joints that the words of create_blocks ask for: single planes, and sets by their
// statistics.
// Scope: words and their limits; what the planes do is in joint_plane.h and natural_joint_set.h.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bond/build/joint_plane.h"
#include "bond/build/natural_joint_set.h"
#include "geometry/size/size_law.h"

namespace muckpile {

struct CutOptions;

/// Least distance of two planes of a set, over block_min: rock between nearer ones would be plates.
inline constexpr double kLeastSpacing = 0.5;
/// Most planes of all sets together; docs/theory/cuts.md has what many planes cost.
inline constexpr int kMostPlanes = 1000;
/// Most discs of all sets together: each is kept, and looked for at every facet of its plane.
inline constexpr int kMostDiscs = 1'000'000;

/// Of the words behind `joint_plane`. Throws InputError.
[[nodiscard]] JointPlane joint_plane_of(const std::vector<std::string>& words);

/// Of the words behind `natural_joints`; none for the spacing 0. Throws InputError.
[[nodiscard]] std::optional<NaturalJointSet> natural_joint_set_of(
    const std::vector<std::string>& words, const SizeLimits& limits);

/// Adds the planes of all sets to those that the cut follows, once the box of the rock is known;
/// set k has its own random numbers, so that one more set leaves the others as they are. Throws
/// InputError where they are more than kMostPlanes, or their discs more than kMostDiscs.
void lay_natural_joint_sets(CutOptions& options);

}  // namespace muckpile
