// SPDX-License-Identifier: GPL-2.0-or-later
// A bench with graded blocks around its holes: the rock by which the cut is judged.
// Scope: the size law is scaled so that about as many blocks come out as asked for.
#pragma once

#include <cstddef>

#include "geometry/cut/tessellation.h"

namespace muckpile::perf {

struct BenchRock {
  std::size_t blocks = 10000;
  double size_ratio = 20.0;  ///< largest over smallest block that the law asks for [-]
  int holes = 1;             ///< in a row, at half a metre from the bench's sides
};

/// Bench of 10 m over a floor of 2 m with its face at x = 0 and holes 3 m behind it.
[[nodiscard]] TessellationOptions graded_bench(const BenchRock& what);

}  // namespace muckpile::perf
