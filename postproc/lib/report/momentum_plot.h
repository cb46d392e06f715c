// SPDX-License-Identifier: GPL-2.0-or-later
// Picture of what gave parts of the rock their speed, over time.
// Scope: a frame per part and direction, four at most.
#pragma once

#include <string>
#include <vector>

#include "draw/canvas.h"
#include "measure/momentum.h"

namespace muckpile {

struct BudgetCurves {
  std::string title;
  std::vector<double> time{};  // [s]
  std::vector<Budget> budgets{};
};

// One of `curves` at least.
Canvas draw_momentum(const std::vector<BudgetCurves>& curves);

}  // namespace muckpile
