// SPDX-License-Identifier: GPL-2.0-or-later
// The polyhedra of blocks.vtk as the engine writes them, read on all cores.
// Scope: a point or a cell a line, one blank between words; what is written otherwise, faulty files
// among it, is left to read_cell_table (geometry/files/cell_file.h).
#pragma once

#include <optional>
#include <vector>

#include "geometry/shape/polyhedron.h"
#include "io/file_text.h"

namespace muckpile {

// Faces turned outwards. None where the file does not begin with plain cells; else `in` stands
// behind them. Throws InputError where a cell is not what it should be.
std::optional<std::vector<Polyhedron>> read_plain_cells(FileWindow& in);

}  // namespace muckpile
