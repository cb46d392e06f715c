// SPDX-License-Identifier: GPL-2.0-or-later
// From words to a floor of surveyed ground.
// Scope: see the header.
#include "geometry/surface/ground_panels.h"

#include <array>
#include <vector>

#include "args/input_error.h"
#include "args/numbers.h"
#include "args/rounded_text.h"
#include "geometry/surface/mine_words.h"

namespace muckpile {
namespace {

constexpr std::size_t kWords = 7;

/// The six numbers behind the file.
FloorExtent extent_of(const std::vector<std::string>& words, const std::string& where) {
  constexpr double kFar = 1e7;
  std::array<double, kWords - 1> value{};
  for (std::size_t k = 0; k < value.size(); ++k)
    value[k] = parse_real(where, "ground", words[k + 1], "m", Range::closed(-kFar, kFar));
  const auto [x_lo, x_hi, y_lo, y_hi, bottom, cell] = value;
  if (!(x_lo < x_hi && y_lo < y_hi))
    refuse(where, "ground needs x and y that rise, got x from '" + words[1] + "' to '" + words[2] +
                      "' and y from '" + words[3] + "' to '" + words[4] + "'");
  if (!(cell > 0.0)) refuse(where, "ground needs panels wider than 0 m, got '" + words[6] + "'");
  return {x_lo, x_hi, y_lo, y_hi, bottom, cell};
}

}  // namespace

ArgTable& add_ground_words(ArgTable& table) {
  return add_mine_words(
      table.group("ground", kWords, kWords, false,
                  "FILE x_lo x_hi y_lo y_hi bottom width: a floor at the heights of surveyed "
                  "ground (files as of `terrain` of create_blocks), with a step at x_lo down to "
                  "bottom, in panels of about that width where there is a survey [m]"),
      "the file of `ground`");
}

GroundPanels ground_panels(const ArgValues& words, const std::string& where) {
  GroundPanels made;
  const auto groups = words.groups("ground");
  for (const char* word : {"origin", "x_bearing", "unit"})
    if (groups.empty() && words.given(word)) refuse(where, std::string(word) + " needs ground");
  if (groups.empty()) return made;
  const std::vector<std::string>& given = groups.front();
  const FloorExtent extent = extent_of(given, where);
  const MineWords mine = read_mine_words(words, where);
  const GroundHeights ground(terrain_triangles(read_placed(given[0], mine.frame, mine.unit)),
                             where + ": ground " + given[0]);
  made.floor = surveyed_floor(ground, extent);
  made.told = where + ": ground of " + given[0] + " from x = " + number_text(extent.x_lo) +
              " m on: " + std::to_string(made.floor.triangles.size()) +
              " triangles between z = " + rounded_text(made.floor.lowest) + " and " +
              rounded_text(made.floor.highest) + " m, in panels of " +
              rounded_text(made.floor.cell) + " m\n";
  return made;
}

}  // namespace muckpile
