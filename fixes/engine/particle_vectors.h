// SPDX-License-Identifier: GPL-2.0-or-later
// Vectors of one particle in the engine's arrays of three numbers each.
// Scope: `values` is the first row of such an array, as in atom->x[0].
#pragma once

#include "math/types.h"

namespace muckpile::engine {

[[nodiscard]] inline Vec3 vector_of(const double* values, int particle) {
  return {values[3 * particle], values[3 * particle + 1], values[3 * particle + 2]};
}

inline void add_to(double* values, int particle, const Vec3& change) {
  for (int d = 0; d < 3; ++d) values[3 * particle + d] += change[d];
}

}  // namespace muckpile::engine
