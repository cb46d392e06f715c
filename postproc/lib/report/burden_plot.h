// SPDX-License-Identifier: GPL-2.0-or-later
// Picture of the burden of each hole over height, against that of the plan.
// Scope: a frame for each hole, all with the same axes.
#pragma once

#include <string>
#include <vector>

#include "draw/canvas.h"
#include "rock/hole_burdens.h"

namespace muckpile {

struct BurdenPoint {
  double height, burden;  // z of the piece; what counts there [m]
  BurdenIs verdict;
};

struct HoleBurdens {
  std::string name;  // of the drilled hole, whose decks stand over each other
  std::vector<BurdenPoint> points;
};

// `plan` [m]; 0: there is none.
Canvas draw_burdens(const std::vector<HoleBurdens>& holes, double plan);

}  // namespace muckpile
