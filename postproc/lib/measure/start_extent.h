// SPDX-License-Identifier: GPL-2.0-or-later
// Where the rock was before the blast.
// Scope: vertices only, as extent_of (measure/columns.h).
#pragma once

#include "measure/columns.h"

namespace muckpile {

// extent_of(blocks, start_snapshot(blocks).states), without the snapshot.
Extent extent_at_start(const std::vector<StartBlock>& blocks);

}  // namespace muckpile
