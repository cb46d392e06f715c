// SPDX-License-Identifier: GPL-2.0-or-later
// The cells of blocks.vtk as the engine writes them, read on all cores.
// Scope: words with one blank or line end between them; what is written otherwise, faulty files
// among it, is left to read_cell_table (geometry/files/cell_file.h).
#pragma once

#include <optional>
#include <string_view>

#include "geometry/files/cell_file.h"

namespace muckpile {

// None where the text does not begin with plain cells; `length` is that of what has been read.
std::optional<CellTable> read_plain_cells(std::string_view text, size_t& length);

}  // namespace muckpile
