// SPDX-License-Identifier: GPL-2.0-or-later
// Whether the surveyed ground is that of the blast: it has one height at each place, the mouths of
// the holes lie on it, and the region of the rock reaches above it.
// Scope: holes of `hole_table`; where surfaces bound the rock. Lengths in metres.
#pragma once

#include <string>

#include "rock/cut_options.h"

namespace muckpile {

/// From the ground, by the nearest way, beyond which the mouth of a hole is warned of, and refused
/// [m]. Ours: the height of a bench changes by decimetres, and stemming is a few metres long.
inline constexpr double kCollarOffGround = 0.5, kCollarElsewhere = 2.0;

/// Share of the plan where the region's top may cut the ground off before that is warned of.
inline constexpr double kCutOffShare = 0.02;

/// After lay_surfaces(). Warnings, "" for none. Throws InputError where a hole begins far from the
/// ground.
[[nodiscard]] std::string ground_checks(const CutOptions& options);

}  // namespace muckpile
