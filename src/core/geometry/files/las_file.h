// SPDX-License-Identifier: GPL-2.0-or-later
// Points of a LAS file, as laser scanners and drones give them.
// Scope: LAS 1.0 to 1.4 (ASPRS), point formats 0 to 3 and 6 to 8; places only. LAZ, which is
// compressed, and formats with wave forms are refused.
#pragma once

#include <filesystem>
#include <vector>

#include "math/types.h"

namespace muckpile {

// In the file's own axes and unit. Points that are marked withheld or classed as noise (7, 18) are
// left out. Throws InputError on a file that is cut, is no such LAS, or has a point outside of the
// box that its header tells.
std::vector<Vec3> read_las(const std::filesystem::path& path);

}  // namespace muckpile
