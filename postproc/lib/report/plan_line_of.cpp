// SPDX-License-Identifier: GPL-2.0-or-later
// The line that a user draws in plan.
// Scope: see the header.
#include "report/plan_line_of.h"

#include "args/input_error.h"
#include "draw/axes.h"
#include "report/mine_pose.h"

namespace muckpile {

PlanLine plan_line_of(const ResultFolder& folder, const LineOptions& options,
                      const std::string& report) {
  PlanLine line{{options.from[0], options.from[1]}, {options.to[0], options.to[1]}};
  if (options.mine) {
    const MineFrame frame =
        required_mine_frame(folder, report, "--from and --to in the run's own x and y");
    for (Vec2* point : {&line.from, &line.to})
      *point = frame.back({point->x(), point->y(), frame.origin.z()}).head<2>();
  }
  constexpr double kShortest = 1e-6, kLongest = 1e5;  // [m]
  if (!(line.length() <= kLongest))
    throw InputError(report + ": --from and --to must be at most 1e5 m apart, got '" +
                     spelled(line.length()) + "'");
  if (line.length() > kShortest) return line;
  throw InputError(report + ": --from and --to must be two points, got '" +
                   spelled(options.from[0], 9) + " " + spelled(options.from[1], 9) + "' twice");
}

std::string words_of(const PlanLine& line) {
  return "from x = " + spelled(line.from.x()) + ", y = " + spelled(line.from.y()) +
         " to x = " + spelled(line.to.x()) + ", y = " + spelled(line.to.y()) + " m";
}

}  // namespace muckpile
