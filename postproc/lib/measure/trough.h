// SPDX-License-Identifier: GPL-2.0-or-later
// The power trough: the valley that a blast leaves between the rock that stands and the pile.
// Scope: one profile of heights along the throw; docs/post/trough.md has the definition.
#pragma once

#include <vector>

namespace muckpile {

struct Trough {
  double x = 0.0, z = 0.0;         // its lowest point [m]; NaN where there is none
  double rim = 0.0;                // height of its lower rim [m]; NaN where there is none
  double depth = 0.0;              // of the lowest point below that rim [m]
  double width = 0.0;              // level distance between its sides at that height [m]
  double area = 0.0;               // between them, below that height [m2]
  double back = 0.0, front = 0.0;  // where these sides are, front along the throw [m]
  double crest = 0.0;              // height of the pile in front of it [m]; NaN where there is none
};

// The deepest valley of a surface, filled to its lower rim: of evenly spaced samples of height
// z [m] over x [m], along the throw. Valleys less than `least` [m] deep are none: all lengths 0.
Trough deepest_trough(const std::vector<double>& x, const std::vector<double>& z, double least);

// The same between the first and the last sample that lie `least` above the floor (NaN: there is
// none): valleys of the ground beyond the pile are none of its.
Trough deepest_trough(const std::vector<double>& x, const std::vector<double>& z,
                      const std::vector<double>& floor, double least);

}  // namespace muckpile
