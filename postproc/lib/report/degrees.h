// SPDX-License-Identifier: GPL-2.0-or-later
// Angles are radians inside and degrees where people read them.
// Scope: reports only.
#pragma once

#include <numbers>

namespace muckpile {

inline double degrees(double radians) { return radians * 180.0 / std::numbers::pi; }

}  // namespace muckpile
