// SPDX-License-Identifier: GPL-2.0-or-later
// Makes sure that a face between two blocks exists in both of them.
// Scope: cells are cut one by one, so a sliver at rounding level may show up on one side only.
#pragma once

#include <cstddef>
#include <vector>

#include "geometry/block_model.h"

namespace muckpile {

// Shrinks faces that the other block does not have to a point; returns how many. Mass properties
// are left alone: the change is at rounding level. Throws std::runtime_error if such a face is
// longer than 1e-5 of its block.
std::size_t collapse_one_sided_faces(std::vector<Block>& blocks);

}  // namespace muckpile
