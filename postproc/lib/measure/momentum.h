// SPDX-License-Identifier: GPL-2.0-or-later
// What gave parts of the rock their speed: momentum by cause, over the mass of the part.
// Scope: blocks of the model, without images behind symmetry planes, which move alike.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "io/blocks_file.h"
#include "io/snapshot.h"
#include "motion/impulse_sums.h"

namespace muckpile {

struct RockPart {
  std::string name;
  double radius =
      0.0;  // mean distance from the axis at the start by mass; NaN where there is none [m]
  double mass = 0.0;  // [kg]
  std::vector<size_t> blocks{};
  std::vector<Vec3> outward{};  // of each of them
};

// Of rock over a charge on the z axis, its centre `depth` [m] below the surface z = 0: `cone`,
// whose sides rise from there at 45 degrees, and `surface`, rings of `width` [m] of the blocks that
// bound the surface. Outward is away from the axis. None for a part without a block.
std::vector<RockPart> crater_parts(const std::vector<StartBlock>& blocks, double depth,
                                   double width);

// Mean speed along one direction [m/s], and what each cause gave of it.
struct Budget {
  double speed = 0.0;
  std::array<double, kImpulseParts> by_cause{};
  // What no cause has given: sums that do not close.
  [[nodiscard]] double left() const;
};
struct PartBudget {
  Budget outward, upward;
};
PartBudget budget_of(const RockPart& part, const std::vector<StartBlock>& blocks,
                     const Snapshot& snapshot, const std::vector<ByPart>& impulses);

}  // namespace muckpile
