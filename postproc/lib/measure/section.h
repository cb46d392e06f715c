// SPDX-License-Identifier: GPL-2.0-or-later
// Vertical section: the polygons in which a plane y = const cuts the posed blocks.
// Scope: convex blocks; a block that only touches the plane gives nothing.
#pragma once

#include <vector>

#include "io/blocks_file.h"
#include "io/snapshot.h"
#include "measure/scan_polygon.h"

namespace muckpile {

struct SectionPolygon {
  size_t block;               // index
  std::vector<Vec2> outline;  // (x, z) [m], in order around the polygon
};

std::vector<SectionPolygon> section_at(double y, const std::vector<StartBlock>& blocks,
                                       const std::vector<BlockState>& states);

}  // namespace muckpile
