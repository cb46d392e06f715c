// SPDX-License-Identifier: GPL-2.0-or-later
// The title of a picture, with a warning behind it.
// Scope: see the header.
#include "draw/title.h"

#include "draw/text.h"

namespace muckpile {
namespace {

// Where the warning begins.
double behind(const std::string& title, double size) {
  return text_mask(title, size, 0.0).advance.x() + 0.8 * size;
}

}  // namespace

void draw_title(const Vec2& place, const std::string& title, const std::string& warning,
                double size, Canvas& canvas) {
  canvas.text(place, title, size, kInk);
  if (warning.empty()) return;
  canvas.text(place + Vec2(behind(title, size), 0.0), warning, size, kSignal);
}

double title_length(const std::string& title, const std::string& warning, double size) {
  if (warning.empty()) return text_mask(title, size, 0.0).advance.x();
  return behind(title, size) + text_mask(warning, size, 0.0).advance.x();
}

}  // namespace muckpile
