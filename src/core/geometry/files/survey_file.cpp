// SPDX-License-Identifier: GPL-2.0-or-later
// A surveyed surface from a file, by the ending of its name.
// Scope: see the header.
#include "geometry/files/survey_file.h"

#include <algorithm>

#include "args/input_error.h"
#include "args/small_letters.h"
#include "args/suggestion.h"
#include "geometry/files/dxf_file.h"
#include "geometry/files/las_file.h"
#include "geometry/files/point_file.h"

namespace muckpile {

namespace {

SurveyedSurface in_unit_of_file(const std::filesystem::path& path, const std::string& ending) {
  if (ending == ".las") return {read_las(path), {}};
  if (ending != ".dxf") return {read_points(path), {}};
  DxfSurface drawing = read_dxf(path);
  if (drawing.triangles.empty()) return {std::move(drawing.points), {}};
  return {{}, std::move(drawing.triangles)};
}

}  // namespace

SurveyedSurface read_survey(const std::filesystem::path& path, double unit) {
  static const std::vector<std::string> kEndings{".xyz", ".csv", ".txt", ".las", ".stl", ".dxf"};
  const std::string ending = in_small_letters(path.extension().string());
  if (std::ranges::find(kEndings, ending) == kEndings.end())
    refuse(path.string(),
           "must be a surface in one of " + joined(kEndings) + ", got '" + ending + "'");
  if (ending == ".stl") return {{}, read_stl(path, unit)};
  SurveyedSurface surface = in_unit_of_file(path, ending);
  for (Vec3& point : surface.points) point *= unit;
  for (StlTriangle& triangle : surface.triangles)
    for (Vec3& corner : triangle) corner *= unit;
  return surface;
}

}  // namespace muckpile
