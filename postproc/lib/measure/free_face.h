// SPDX-License-Identifier: GPL-2.0-or-later
// The free face of a bench before the blast, as it is seen along -x: where its rock begins.
// Scope: rock above the pit floor z = 0; top, floor, back and the sides along y are not looked at.
#pragma once

#include <memory>
#include <vector>

#include "io/blocks_file.h"
#include "measure/face_map.h"

namespace muckpile {

struct FreeFace {
  double x_low, x_high;  // where the face lies, its least and greatest x [m]
  double slope;          // angle of the plane that fits it best, from the horizontal [rad]
  double back;           // how far the plane that is taken for it runs back per height; 0: upright
  double off_plane;      // share of its area that lies farther from that plane than the tolerance
};

// Looks along lines parallel to x, four to a mean block in y and z. Where a line meets no rock the
// face is off the plane. The plane goes through the toe x = 0, z = 0: upright, or leaning back as
// the middle one of the lines does where that leaves less off. `tolerance` in m, along x. All NaN
// and 1 for rock that does not reach above z = 0.
FreeFace free_face(const std::vector<StartBlock>& blocks, double tolerance);

// Where those lines meet the rock. None for rock that does not reach above z = 0.
std::shared_ptr<const FaceMap> face_map(const std::vector<StartBlock>& blocks);

}  // namespace muckpile
