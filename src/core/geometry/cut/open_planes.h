// SPDX-License-Identifier: GPL-2.0-or-later
// Faces of blocks in a plane of the cut that have nothing behind them although rock should be
// there. Scope: of a finished cut; those that look into the void of a hole are on that hole and no
// such faces.
#pragma once

#include <cstddef>
#include <vector>

#include "geometry/cut/tessellation.h"

namespace muckpile {

struct OpenPlanes {
  std::size_t faces = 0;
  double area = 0.0;  // of these [m2]
  double all = 0.0;   // of all faces in the planes within the rock, each side counted [m2]
};

[[nodiscard]] OpenPlanes open_planes(const TessellationOptions& options,
                                     const std::vector<Block>& blocks);

}  // namespace muckpile
