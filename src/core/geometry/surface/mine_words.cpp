// SPDX-License-Identifier: GPL-2.0-or-later
// From words to the place of files in mine coordinates.
// Scope: see the header.
#include "geometry/surface/mine_words.h"

#include <cmath>

#include "args/numbers.h"

namespace muckpile {

ArgTable& add_mine_words(ArgTable& table, const std::string& files) {
  return table
      .group(
          "origin", 3, 3, false,
          "x y z that " + files +
              " have at 0 0 0 of the run [m], as east, north and height of a mine; default 0 0 0")
      .real("x_bearing", "deg", Range::closed(0.0, 360.0), 90.0,
            "that the x axis of the run looks to in those files, from north (y) over east (x)")
      .word("unit", {}, "auto",
            "what the numbers of those files count in [m], 1e-4 to 1e4: 0.3048 for feet; auto: 1, "
            "and a file whose size looks like another unit is refused");
}

MineWords read_mine_words(const ArgValues& args, const std::string& where) {
  constexpr double kFarthest = 1e7;  // [m]
  MineWords words;
  words.frame.bearing = args.real("x_bearing") * M_PI / 180.0;
  for (const auto& given : args.groups("origin"))
    for (int c = 0; c < 3; ++c)
      words.frame.origin[c] = parse_real(where, "origin", given[static_cast<std::size_t>(c)], "m",
                                         Range::closed(-kFarthest, kFarthest));
  const std::string& unit = args.word("unit");
  words.unit_given = unit != "auto";
  if (words.unit_given) words.unit = parse_real(where, "unit", unit, "m", Range::closed(1e-4, 1e4));
  return words;
}

SurveyedSurface read_placed(const std::string& file, const MineFrame& frame, double unit) {
  SurveyedSurface survey = read_survey(file, unit);
  for (Vec3& point : survey.points) point = frame.to_run(point);
  for (StlTriangle& triangle : survey.triangles)
    for (Vec3& corner : triangle) corner = frame.to_run(corner);
  return survey;
}

}  // namespace muckpile
