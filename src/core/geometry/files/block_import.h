// SPDX-License-Identifier: GPL-2.0-or-later
// Blocks that another program has cut, from a VTK file: read, checked, and their shared faces
// found. Scope: legacy ASCII files up to version 4 with convex cells (polyhedra, tetrahedra,
// hexahedra, wedges, pyramids), as write_blocks() makes them; lengths in metres.
#pragma once

#include <istream>
#include <string>
#include <vector>

#include "geometry/cut/tessellation.h"

namespace muckpile {

/// The cells as they stand in the file, faces turned outwards. `name` is used in messages. Throws
/// InputError where the file is not what it should be.
[[nodiscard]] std::vector<Polyhedron> read_cells(std::istream& in, const std::string& name);

/// Cells as blocks. Faces of two blocks that lie in one plane become facets where they overlap.
/// Throws InputError naming the cell (from 1) that is not closed or convex, or the two that
/// overlap.
[[nodiscard]] std::vector<Block> joined_blocks(std::vector<Polyhedron> cells);

/// Reads and joins the cells of a file. A face that looks into a void of the region within four
/// radii of a hole's axis belongs to that hole. Throws InputError for a cell whose size is not
/// within the limits of `rock.size`, or whose centroid is not in the region.
[[nodiscard]] Tessellation import_blocks(const std::string& path, const TessellationOptions& rock);

}  // namespace muckpile
