// SPDX-License-Identifier: GPL-2.0-or-later
// Blocks that another program has cut: its cells checked, and their shared faces found.
// Scope: convex cells, as cell_file.h reads them; lengths in metres.
#pragma once

#include <string>
#include <vector>

#include "geometry/cut/tessellation.h"

namespace muckpile {

/// Cells as blocks. Faces of two blocks that lie in one plane become facets where they overlap.
/// Throws InputError naming the cell (from 1) that is not closed or convex, or the two that
/// overlap.
[[nodiscard]] std::vector<Block> joined_blocks(std::vector<Polyhedron> cells);

/// Reads and joins the cells of a file. A face that looks into a void of the region within four
/// radii of a hole's axis belongs to that hole. Throws InputError for a cell whose size is not
/// within the limits of `rock.size`, or whose centroid is not in the region.
[[nodiscard]] Tessellation import_blocks(const std::string& path, const TessellationOptions& rock);

}  // namespace muckpile
