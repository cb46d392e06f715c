// SPDX-License-Identifier: GPL-2.0-or-later
// Cuts a region of rock by sets of parallel joints whose spacing is graded: concentric bands around
// the charges in which the spacing of one set after the other halves.
// Limits: three sets, or two and a third at right angles to both; blocks are convex.
#pragma once

#include <vector>

#include "geometry/cut/tessellation.h"

namespace muckpile {

struct JointSet {
  Vec3 normal = Vec3::UnitZ();  // of any length but 0
  double spacing = 1.0;         // relative to the other sets'
};

struct JointSetCut {
  std::vector<JointSet> sets;
  // No division makes a block with 3 V / A (mean_radius) below this share of the size asked for
  // there, or thinner along a set's normal than twice this share: what would be a sliver stays part
  // of its neighbour, or of the void at a crushed zone.
  double sliver = kThinnestPart;
};

/// `rock.sweeps` and `rock.seed` are not used. Blocks fill the rock; every facet is the polygon
/// that two blocks share, so that a block may have several in one plane. Flat surfaces of a region
/// are followed exactly, curved ones by one plane per block. Throws InputError as tessellate()
/// does, and for other than two or three sets, sets that are nearly parallel or sliver outside 0 to
/// 0.3.
[[nodiscard]] Tessellation cut_by_joint_sets(const TessellationOptions& rock,
                                             const JointSetCut& how);

}  // namespace muckpile
