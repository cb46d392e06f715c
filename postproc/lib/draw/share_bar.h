// SPDX-License-Identifier: GPL-2.0-or-later
// One bar that is cut into shares, with a key below it.
// Scope: shares of one whole; the bar is as wide as the canvas less its margins.
#pragma once

#include <string>
#include <vector>

#include "draw/canvas.h"

namespace muckpile {

struct BarShare {
  std::string label;
  double share;  // of the whole [-]; less than 0: as none
};

inline constexpr double kShareBarHeight = 170.0;  // with title and key [px]

// `top` is the upper edge of its title [px]. Shares below a thousandth are left out.
void draw_share_bar(Canvas& canvas, double top, const std::string& title,
                    const std::vector<BarShare>& shares);

}  // namespace muckpile
