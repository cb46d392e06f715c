// SPDX-License-Identifier: GPL-2.0-or-later
// Parts of rock between planes, tessellated each by itself, joined again in the planes.
// Scope: serial and deterministic. Where the blocks on the two sides of a plane do not match, at
// crossings, their faces in it are divided into what each pair of blocks shares: a block may have
// several.
#pragma once

#include <vector>

#include "geometry/cut/tessellation.h"

namespace muckpile {

/// Makes neighbours of blocks whose free faces overlap in one of the planes.
void join_in_planes(const std::vector<CutPlane>& planes, std::vector<Block>& blocks);

}  // namespace muckpile
