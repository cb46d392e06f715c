// SPDX-License-Identifier: GPL-2.0-or-later
// The words on a picture of the rock: title and colour key above, caption below.
// Scope: pictures of 200 px and more; the scale bar in the lower right corner is picture_view.h's.
#pragma once

#include <string>
#include <vector>

#include "draw/canvas.h"
#include "report/block_colours.h"

namespace muckpile {

struct PictureWords {
  std::string title, warning;        // the latter may be empty
  std::vector<std::string> caption;  // its parts, one at least
};

// On veils over the rock. In a picture that is too narrow for all side by side, the key stands
// below the title and the caption above the scale bar, and what is still too wide becomes smaller.
void draw_words(const PictureWords& words, const BlockColours& colours, Canvas& canvas);

}  // namespace muckpile
