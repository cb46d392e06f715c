// SPDX-License-Identifier: GPL-2.0-or-later
// Products of Vec3 by the names that vectors in lanes have, for formulas written for both.
// Scope: inner loops of src/core.
#pragma once

#include "math/lanes.h"
#include "math/types.h"

namespace muckpile {

[[nodiscard]] inline double dot(const Vec3& a, const Vec3& b) { return a.dot(b); }
[[nodiscard]] inline Vec3 cross(const Vec3& a, const Vec3& b) { return a.cross(b); }

}  // namespace muckpile
