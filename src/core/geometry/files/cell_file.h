// SPDX-License-Identifier: GPL-2.0-or-later
// Cells of a VTK file, as another program or write_blocks() wrote them.
// Scope: legacy ASCII files up to version 4 with polyhedra, tetrahedra, hexahedra, wedges and
// pyramids; lengths in metres. What the cells are worth as blocks is checked in block_import.h.
#pragma once

#include <istream>
#include <string>
#include <vector>

#include "geometry/shape/polyhedron.h"

namespace muckpile {

/// The cells as they stand in the file, faces turned outwards. `name` is used in messages. Throws
/// InputError where the file is not what it should be.
[[nodiscard]] std::vector<Polyhedron> read_cells(std::istream& in, const std::string& name);

}  // namespace muckpile
