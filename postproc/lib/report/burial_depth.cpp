// SPDX-License-Identifier: GPL-2.0-or-later
// How deep the charge of a crater lies.
// Scope: see the header.
#include "report/burial_depth.h"

#include "args/input_error.h"
#include "draw/axes.h"

namespace muckpile {

double burial_depth(const ResultFolder& folder) {
  constexpr double kLeast = 1e-3, kMost = 1e4;  // [m]
  const double depth = folder.scene_number("burial_depth_m");
  if (depth >= kLeast && depth <= kMost) return depth;
  throw InputError(folder.dump("scene.json").string() +
                   ": burial_depth_m must be 1e-3 to 1e4 m, got '" + spelled(depth) + "'");
}

}  // namespace muckpile
