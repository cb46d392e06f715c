// SPDX-License-Identifier: GPL-2.0-or-later
// Words as a mask of pixels, set in the sans-serif font that VTK carries within itself.
// Scope: one line of UTF-8; no font file of the machine is used.
#pragma once

#include <string>
#include <vector>

#include "measure/scan_polygon.h"

namespace muckpile {

struct TextMask {
  int width = 0, height = 0;
  double left = 0.0, top = 0.0;      // of the mask, from the start of the base line, y down
  Vec2 advance = Vec2::Zero();       // from the start to the end of the base line, y down
  std::vector<unsigned char> cover;  // row by row from the top
  [[nodiscard]] double at(int x, int y) const {
    return cover[static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x)] /
           255.0;
  }
};

// `size` is the height of the letters' body in pixels; `degrees` counter-clockwise.
TextMask text_mask(const std::string& words, double size, double degrees);

// `size`, or the smaller one at which level words are `length` long, both [px].
double fitting_size(const std::string& words, double size, double length);

}  // namespace muckpile
