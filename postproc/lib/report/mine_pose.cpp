// SPDX-License-Identifier: GPL-2.0-or-later
// What --mine stands for.
// Scope: see the header.
#include "report/mine_pose.h"

#include <numbers>

#include "args/input_error.h"

namespace muckpile {

MineFrame required_mine_frame(const ResultFolder& folder, const std::string& report,
                              const std::string& instead) {
  const std::optional<MineFrame> frame = mine_frame(folder);
  if (frame) return *frame;
  throw InputError(report +
                   ": --mine needs the run's place in the mine, terrain_east_m, terrain_north_m, "
                   "terrain_height_m and x_bearing_deg of scene.json, which do not tell it; give " +
                   instead);
}

void set_mine_pose(const ResultFolder& folder, const std::string& report,
                   std::array<double, 3>& shift, double& turn_deg) {
  const MineFrame frame = required_mine_frame(folder, report, "--shift and --turn");
  shift = {-frame.origin.x(), -frame.origin.y(), -frame.origin.z()};
  turn_deg = frame.bearing * 180.0 / std::numbers::pi - 90.0;
}

}  // namespace muckpile
