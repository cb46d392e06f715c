// SPDX-License-Identifier: GPL-2.0-or-later
// The words on a picture of the rock.
// Scope: see the header.
#include "report/picture_words.h"

#include <algorithm>
#include <cmath>

#include "args/suggestion.h"
#include "draw/text.h"
#include "draw/title.h"

namespace muckpile {
namespace {

constexpr double kMargin = 28.0;                  // beside the words [px]
constexpr double kTitleSize = 28.0, kGap = 40.0;  // [px]

void draw_above(const PictureWords& words, const BlockColours& colours, Canvas& canvas) {
  constexpr double kAbove = 92.0, kRow = 54.0;         // heights [px]
  constexpr double kFromRight = kLegendLength + 40.0;  // to where the key begins [px]
  const double room = canvas.width() - 2.0 * kMargin;
  const double title = title_length(words.title, words.warning, kTitleSize);
  const bool beside = kMargin + title + kGap <= canvas.width() - kFromRight;
  canvas.rectangle({0.0, 0.0}, {1.0 * canvas.width(), kAbove + (beside ? 0.0 : kRow)}, kWhite);
  draw_title({kMargin, 46.0}, words.title, words.warning,
             std::floor(kTitleSize * std::min(1.0, room / title)), canvas);
  if (beside) {
    draw_legend(colours, {canvas.width() - kFromRight, 18.0}, canvas);
  } else {
    draw_legend(colours, {kMargin, 18.0 + kRow}, canvas, std::min(kLegendLength, room));
  }
}

// Beside the scale bar unless that needs letters smaller than these.
void draw_below(const std::vector<std::string>& caption, Canvas& canvas) {
  constexpr double kSize = 18.0, kLeast = 11.0, kBar = 250.0;         // [px]
  constexpr double kBelow = 66.0, kBase = 20.0, kLine = 1.3 * kSize;  // heights [px]
  const double right = canvas.width(), bottom = canvas.height();
  const std::string all = joined(caption, "; ");
  const double size = fitting_size(all, kSize, right - kMargin - kBar);
  const bool beside = size >= kLeast;
  const double lines = beside ? 0.0 : kLine * static_cast<double>(caption.size());
  canvas.rectangle({0.0, bottom - kBelow - lines}, {right, bottom}, kWhite);
  if (beside) {
    canvas.text({kMargin, bottom - kBase}, all, size, kInk);
    return;
  }
  double y = bottom - kBelow - lines;
  for (const std::string& part : caption) {
    y += kLine;
    canvas.text({kMargin, y}, part, fitting_size(part, kSize, right - 2.0 * kMargin), kInk);
  }
}

}  // namespace

void draw_words(const PictureWords& words, const BlockColours& colours, Canvas& canvas) {
  draw_above(words, colours, canvas);
  draw_below(words.caption, canvas);
}

}  // namespace muckpile
