// SPDX-License-Identifier: GPL-2.0-or-later
// What a file of cells says of each cell behind its shape: one named number per cell.
// Scope: legacy ASCII VTK, SCALARS of one component; cell_file.h reads the shapes before it.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "args/text_words.h"

namespace muckpile {

using CellData = std::map<std::string, std::vector<double>>;

/// What stands behind the cells of `text`. Throws InputError, naming `file`, if it is no cell data
/// or a number is missing.
[[nodiscard]] CellData read_cell_data(TextWords& text, std::size_t cells, const std::string& file);

/// One of them. Throws InputError, naming `file`, if there is none of that name.
[[nodiscard]] const std::vector<double>& cell_array(const CellData& data, const char* name,
                                                    const std::string& file);

}  // namespace muckpile
