// SPDX-License-Identifier: GPL-2.0-or-later
// A surface of four-cornered panels as the text of an STL file.
// Scope: for floors, walls and gates of a scene; whether panels fit together is the caller's
// affair.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "args/parse_args.h"
#include "geometry/files/stl_file.h"
#include "math/types.h"

namespace muckpile {

[[nodiscard]] ArgTable write_panels_table();

/// Cut into `along` parts from corner 1 to 2 and `across` parts from corner 1 to 4, each of two
/// triangles. Its corners turn anticlockwise seen from where the normals point.
struct Panel {
  std::array<Vec3, 4> corners;  ///< [m]
  int along = 1, across = 1;
};

/// The panels of write_panels, none where it has ground alone. InputError, which begins with
/// `where`: a word is no number, or a panel has no area.
[[nodiscard]] std::vector<Panel> panels_of(const ArgValues& words, const std::string& where);

/// Panels, then single triangles. Coordinates have 15 digits. Panels with an edge and its number of
/// parts in common share the points on it to the last digit.
[[nodiscard]] std::string stl_text(const std::string& name, std::span<const Panel> panels,
                                   std::span<const StlTriangle> triangles = {});

}  // namespace muckpile
