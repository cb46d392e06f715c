// SPDX-License-Identifier: GPL-2.0-or-later
// Cells of a VTK file, as another program or write_blocks() wrote them.
// Scope: legacy ASCII files up to version 4 with polyhedra, tetrahedra, hexahedra, wedges and
// pyramids; lengths in metres. What the cells are worth as blocks is checked in block_import.h.
#pragma once

#include <string>
#include <vector>

#include "args/text_words.h"
#include "geometry/shape/polyhedron.h"

namespace muckpile {

/// The cells as they stand in the file, faces turned outwards. `name` is used in messages. Throws
/// InputError where the file is not what it should be.
/// What stands behind the cells is left in `text`.
[[nodiscard]] std::vector<Polyhedron> read_cells(TextWords& text, const std::string& name);

}  // namespace muckpile
