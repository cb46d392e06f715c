// SPDX-License-Identifier: GPL-2.0-or-later
// The title of a picture, with a warning behind it.
// Scope: one line.
#pragma once

#include <string>

#include "draw/canvas.h"

namespace muckpile {

// `place` [px] is the start of the base line. An empty warning is left out.
void draw_title(const Vec2& place, const std::string& title, const std::string& warning,
                double size, Canvas& canvas);

// Of both [px].
double title_length(const std::string& title, const std::string& warning, double size);

}  // namespace muckpile
