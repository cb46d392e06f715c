// SPDX-License-Identifier: GPL-2.0-or-later
// Points of a surveyed surface from a text file.
// Scope: .xyz, .csv and .txt: one point a line, in any order, on a grid or not.
#pragma once

#include <filesystem>
#include <vector>

#include "math/types.h"

namespace muckpile {

// Fields stand between semicolons, else commas, else blanks, whichever the first line has. A header
// names the columns x, y, z (also x_m, easting, north, elevation ...); without one they are the
// first three. Lines that begin with # are remarks. Throws InputError, with file and line, on a
// field that is no finite number, on rows of unlike length and on fewer than three points.
std::vector<Vec3> read_points(const std::filesystem::path& path);

}  // namespace muckpile
