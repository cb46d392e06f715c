// SPDX-License-Identifier: GPL-2.0-or-later
// Triangles of an STL file.
// Scope: text and binary; normals and attributes are not read.
#pragma once

#include <array>
#include <filesystem>
#include <vector>

#include "math/types.h"

namespace muckpile {

using StlTriangle = std::array<Vec3, 3>;

// Throws InputError on a file that is cut, is no STL, or has a triangle without an area or a corner
// that is no finite number, with the line of a text file and the number of the triangle of a binary
// one; and on a binary one whose coordinates are so large that its 32 bits round them to more than
// 5 cm. `unit` is what its numbers count in [m]; the corners are in metres.
std::vector<StlTriangle> read_stl(const std::filesystem::path& path, double unit);

// Those of the first solid of a text file that may have several.
std::vector<StlTriangle> read_first_solid(const std::filesystem::path& path, double unit);

}  // namespace muckpile
