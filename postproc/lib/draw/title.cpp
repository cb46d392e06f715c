// SPDX-License-Identifier: GPL-2.0-or-later
// The title of a picture, with a warning behind it.
// Scope: see the header.
#include "draw/title.h"

#include "draw/text.h"

namespace muckpile {

void draw_title(const Vec2& place, const std::string& title, const std::string& warning,
                double size, Canvas& canvas) {
  canvas.text(place, title, size, kInk);
  if (warning.empty()) return;
  const double behind = text_mask(title, size, 0.0).advance.x() + 0.8 * size;
  canvas.text(place + Vec2(behind, 0.0), warning, size, kSignal);
}

}  // namespace muckpile
