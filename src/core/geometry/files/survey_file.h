// SPDX-License-Identifier: GPL-2.0-or-later
// A surveyed surface from a file, by the ending of its name.
// Scope: points (.xyz, .csv, .txt, .las, points of .dxf) or triangles (.stl, faces of .dxf), in the
// file's own axes.
#pragma once

#include <filesystem>
#include <vector>

#include "geometry/files/stl_file.h"
#include "math/types.h"

namespace muckpile {

// One of the two is empty.
struct SurveyedSurface {
  std::vector<Vec3> points;            // [m]
  std::vector<StlTriangle> triangles;  // [m]
};

// `unit` is what the file's numbers count in [m]. Throws InputError as geometry/files/point_file.h,
// geometry/files/las_file.h, stl_file.h and dxf_file.h tell, and for another ending.
SurveyedSurface read_survey(const std::filesystem::path& path, double unit);

}  // namespace muckpile
