// SPDX-License-Identifier: GPL-2.0-or-later
// The floor of surveyed ground by the words of write_panels.
// Scope: words, their checks, the file placed by them; SI units.
#pragma once

#include <string>
#include <vector>

#include "args/parse_args.h"
#include "geometry/surface/surveyed_floor.h"

namespace muckpile {

/// Adds `ground` and where its file lies.
ArgTable& add_ground_words(ArgTable& table);

struct GroundPanels {
  SurveyedFloor floor{{}, {}, 0.0, 0.0, 0.0};  ///< with its walls; nothing without ground
  std::vector<StlTriangle> under_rock;         ///< what the rock stands on between ground beside it
  double front = 0.0;                          ///< mean height where it begins at the rock [m]
  std::string told;                            ///< lines for the log
};

/// `where` begins each message.
[[nodiscard]] GroundPanels ground_panels(const ArgValues& words, const std::string& where);

}  // namespace muckpile
