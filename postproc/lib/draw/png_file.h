// SPDX-License-Identifier: GPL-2.0-or-later
// Writes a finished canvas as a PNG file.
// Scope: 8 bits per channel, no transparency.
#pragma once

#include <filesystem>

#include "draw/canvas.h"

namespace muckpile {

// Throws InputError, naming the file, if it cannot be written.
void write_png(const Canvas& canvas, const std::filesystem::path& path);

}  // namespace muckpile
