// SPDX-License-Identifier: GPL-2.0-or-later
// A surveyed surface from a file, by the ending of its name.
// Scope: see the header.
#include "io/survey_file.h"

#include <algorithm>
#include <cctype>

#include "args/input_error.h"
#include "io/point_file.h"

namespace muckpile {

SurveyedSurface read_survey(const std::filesystem::path& path, double unit) {
  std::string ending = path.extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return std::tolower(c); });
  if (ending == ".stl") return {{}, read_stl(path, unit)};
  if (ending != ".xyz" && ending != ".csv" && ending != ".txt")
    refuse(path.string(), "must be a surface in .xyz, .csv, .txt or .stl, got '" + ending + "'");
  std::vector<Vec3> points = read_points(path);
  for (Vec3& point : points) point *= unit;
  return {std::move(points), {}};
}

}  // namespace muckpile
