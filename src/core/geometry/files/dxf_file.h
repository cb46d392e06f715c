// SPDX-License-Identifier: GPL-2.0-or-later
// Drawings in DXF: surfaces in.
// Scope: text DXF. Read are 3DFACE, polyface meshes and POINT of the section ENTITIES, whatever
// their layer.
#pragma once

#include <filesystem>
#include <vector>

#include "geometry/files/stl_file.h"
#include "math/types.h"

namespace muckpile {

struct DxfSurface {
  std::vector<StlTriangle> triangles;  // of faces; one of four corners is two
  std::vector<Vec3> points;
};

// In the file's own axes and unit. Throws InputError, with file and line, on a file that is cut, is
// binary or no DXF, has a face with a corner that is no finite number or is not there, or neither a
// face nor three points.
DxfSurface read_dxf(const std::filesystem::path& path);

}  // namespace muckpile
