// SPDX-License-Identifier: GPL-2.0-or-later
// Words that stand beside figures, so that they are not taken for more than they are.
// Scope: text for summary.json and the pictures; docs/post explains each.
#pragma once

#include <cmath>
#include <string>

#include "draw/axes.h"

namespace muckpile {

inline constexpr const char* kStillMoving = "STILL MOVING";

// "" for a run that ended at rest, else what its pictures carry.
inline std::string motion_warning(bool still) { return still ? "" : kStillMoving; }

// Of a run that ended in motion at this time [s].
inline std::string motion_note(double time) {
  return std::string(kStillMoving) + " at " + spelled(time) +
         " s: throw and face velocity are those so far; a pile at rest is not there to be measured";
}

inline constexpr const char* kLargestThrowNote =
    "no clearance distance: the farthest block of one run of a model without fly rock";

inline constexpr const char* kFlyrockNote =
    "formulas, no results of the simulation: ranges of fly rock after Richards & Moore, and after "
    "McKenzie; a clearance needs a constant k of the site, and a factor of 2 is none for people";

inline constexpr const char* kOpenHoleNote =
    "no clearance: a hole without stemming shoots into the open, and no formula tells how far";

inline constexpr const char* kFinesLawNote =
    "a law, no result of the simulation: broken-out rock near the charges is fine, in the form of "
    "Djordjevic 1999; radius and sizes are chosen, not measured";
inline constexpr const char* kBlockSizesNote = "block sizes: the input, not a prediction";

// Above this share of single blocks in the pile's mass the size curve is that of the cut.
inline constexpr double kMostlySingleBlocks = 0.95;

inline bool is_the_input(double single_block_share) {
  return single_block_share > kMostlySingleBlocks;
}

}  // namespace muckpile
