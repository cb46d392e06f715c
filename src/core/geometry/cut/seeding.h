// SPDX-License-Identifier: GPL-2.0-or-later
// Random seeds whose number density is 1 / size^3, and their expected number.
// Scope: start positions only; the Lloyd sweeps of the tessellation even them out.
#pragma once

#include <vector>

#include "geometry/cut/ground.h"
#include "geometry/cut/tessellation.h"

namespace muckpile {

// Integral of dV / size^3 over the rock [-]; stops as soon as it is above `give_up`.
[[nodiscard]] double integrate_density(const TessellationOptions& options, const Ground& ground,
                                       double give_up);

// One seed per unit of the integral, in the order of a tree walk.
[[nodiscard]] std::vector<Vec3> scatter_seeds(const TessellationOptions& options,
                                              const Ground& ground);

}  // namespace muckpile
