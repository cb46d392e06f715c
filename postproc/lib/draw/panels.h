// SPDX-License-Identifier: GPL-2.0-or-later
// Several plots of the same curves in one picture, with one title and one key.
// Scope: two side by side, from the top; the curves of each plot have the same labels and colours.
#pragma once

#include <string>
#include <vector>

#include "draw/curve_plot.h"

namespace muckpile {

struct Panels {
  std::string title, warning, remark;  // the latter two may be empty
  std::vector<CurvePlot> plots;        // one at least; the title of each stands above its frame
};

// 1200 px wide. The key is that of the first plot.
Canvas draw_panels(const Panels& panels);

}  // namespace muckpile
