// SPDX-License-Identifier: GPL-2.0-or-later
// Cells of a VTK file, as another program or write_blocks() wrote them.
// Scope: legacy ASCII files up to version 4 with polyhedra, tetrahedra, hexahedra, wedges and
// pyramids; lengths in metres. What the cells are worth as blocks is checked in block_import.h.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "args/text_words.h"
#include "geometry/shape/polyhedron.h"

namespace muckpile {

/// What a file says of its cells, before polyhedra are made of it.
struct CellTable {
  std::vector<Vec3> points;        // [m]
  std::vector<int> words;          // the CELLS lines one after another, each with its count
  std::vector<std::size_t> begin;  // of each cell in `words`, behind its count
  std::vector<int> types;          // VTK's, of each cell
  [[nodiscard]] std::size_t cells() const { return begin.size(); }

  /// Fills `begin`. False where the counts do not make up `cells` lines and no more.
  [[nodiscard]] bool find_cells(std::size_t cells);
};

/// What stands behind the cells is left in `text`. Throws as read_cells() does.
[[nodiscard]] CellTable read_cell_table(TextWords& text, const std::string& name);

/// Cell `number` of the table, counted from 0; faces turned outwards. Throws InputError where it is
/// not what a cell should be.
[[nodiscard]] Polyhedron cell_of(const CellTable& table, std::size_t number);

/// The same, with the file's name ahead of the message.
[[nodiscard]] Polyhedron cell_of(const CellTable& table, std::size_t number,
                                 const std::string& name);

/// The same of the words behind the count of its line, of VTK's `type`.
[[nodiscard]] Polyhedron cell_of(std::span<const int> words, int type,
                                 const std::vector<Vec3>& points, std::size_t number);

/// Whether a cell of these vertices lies in front of a face, by the order of the face's corners.
[[nodiscard]] bool faces_inwards(std::span<const Vec3> vertices, std::span<const int> face);

/// The cells as they stand in the file, faces turned outwards. `name` is used in messages. Throws
/// InputError where the file is not what it should be.
/// What stands behind the cells is left in `text`.
[[nodiscard]] std::vector<Polyhedron> read_cells(TextWords& text, const std::string& name);

}  // namespace muckpile
