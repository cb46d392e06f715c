// SPDX-License-Identifier: GPL-2.0-or-later
// One bar that is cut into shares, with a key below it.
// Scope: see the header.
#include "draw/share_bar.h"

#include <cmath>

#include "draw/curve_plot.h"
#include "draw/text.h"

namespace muckpile {
namespace {

constexpr double kMargin = 110.0, kRight = 30.0;                       // [px]
constexpr double kTitleSize = 20.0, kKeySize = 18.0, kKeyLine = 26.0;  // [px]
constexpr double kBarTop = 32.0, kBarHeight = 36.0;                    // under `top` [px]
constexpr double kLeast = 1e-3;                                        // share that is drawn

std::string in_words(const BarShare& share) {
  const double percent = 100.0 * share.share;
  return share.label + " " + spelled(percent, percent < 10.0 ? 2 : 3) + " %";
}

}  // namespace

void draw_share_bar(Canvas& canvas, double top, const std::string& title,
                    const std::vector<BarShare>& shares) {
  const double width = canvas.width() - kMargin - kRight, bar = top + kBarTop;
  canvas.text({kMargin, top + kTitleSize}, title, kTitleSize, kInk);
  double left = kMargin, x = kMargin, y = bar + kBarHeight + kKeyLine;
  int number = 0;
  for (const BarShare& share : shares) {
    if (share.share < kLeast) continue;
    const Colour colour = colour_of_curve(number++);
    canvas.rectangle({left, bar}, {left + share.share * width, bar + kBarHeight}, colour);
    left += share.share * width;
    const std::string words = in_words(share);
    const double long_as = kKeySize + 30.0 + text_mask(words, kKeySize, 0.0).advance.x();
    if (x > kMargin && x + long_as > canvas.width() - kRight) {
      x = kMargin;
      y += kKeyLine;
    }
    canvas.rectangle({x, y - 0.8 * kKeySize}, {x + 0.8 * kKeySize, y}, colour);
    canvas.text({x + kKeySize + 4.0, y}, words, kKeySize, kInk);
    x += long_as;
  }
}

}  // namespace muckpile
