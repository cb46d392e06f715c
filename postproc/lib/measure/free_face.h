// SPDX-License-Identifier: GPL-2.0-or-later
// The free face of a bench before the blast, as it is seen along -x: where its rock begins.
// Scope: rock above the pit floor z = 0; top, floor, back and the sides along y are not looked at.
#pragma once

#include <vector>

#include "io/blocks_file.h"

namespace muckpile {

struct FreeFace {
  double x_low, x_high;  // where the face lies, its least and greatest x [m]
  double slope;          // angle of the plane that fits it best, from the horizontal [rad]
  double off_plane;      // share of its area that lies farther from x = 0 than the tolerance
};

// Looks along lines parallel to x, four to a mean block in y and z. Where a line meets no rock the
// face is off the plane. `tolerance` in m. All NaN and 1 for rock that does not reach above z = 0.
FreeFace free_face(const std::vector<StartBlock>& blocks, double tolerance);

}  // namespace muckpile
