// SPDX-License-Identifier: GPL-2.0-or-later
// The keywords by which styles take files in mine coordinates.
// Scope: words, their checks, and files placed by them; SI units.
#pragma once

#include <string>

#include "args/parse_args.h"
#include "geometry/files/survey_file.h"
#include "geometry/surface/rock_body.h"

namespace muckpile {

/// Adds `origin`, `x_bearing` and `unit` of the files named so.
ArgTable& add_mine_words(ArgTable& table, const std::string& files);

/// Of inputs/quarry, that sets `unit` of all files in mine coordinates.
inline constexpr const char* kUnitKnob = "terrain_unit";

/// How files lie in the run.
struct MineWords {
  MineFrame frame{};
  double unit = 1.0;        ///< that they count in [m]
  bool unit_given = false;  ///< the script says so
};

/// `where` begins each message.
[[nodiscard]] MineWords read_mine_words(const ArgValues& args, const std::string& where);

/// Of a file, in the frame of the run. Throws InputError as read_survey() does.
[[nodiscard]] SurveyedSurface read_placed(const std::string& file, const MineFrame& frame,
                                          double unit);

}  // namespace muckpile
