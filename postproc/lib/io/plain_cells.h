// SPDX-License-Identifier: GPL-2.0-or-later
// The polyhedra of blocks.vtk as the engine writes them, read on all cores.
// Scope: a point or a cell a line, one blank between words, the corners of a cell points that
// follow each other in the file; what is written otherwise, faulty files among it, is left to
// read_cell_table (geometry/files/cell_file.h).
#pragma once

#include <optional>
#include <vector>

#include "io/block_shape.h"
#include "io/file_text.h"

namespace muckpile {

// Faces turned outwards. None where the file does not begin with plain cells; else `in` stands
// behind them.
std::optional<std::vector<BlockShape>> read_plain_cells(FileWindow& in);

}  // namespace muckpile
