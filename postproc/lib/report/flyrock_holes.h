// SPDX-License-Identifier: GPL-2.0-or-later
// What formulas of fly rock ask of each hole of a bench.
// Scope: of the hole table of the run, else of the equal holes of its scene.
#pragma once

#include <string>
#include <vector>

#include "io/result_folder.h"

namespace muckpile {

struct FlyrockHole {
  std::string name;
  int row = 0;            // from 0, at the face
  double diameter;        // [m]
  double burden;          // to the free face [m]; NaN behind the first row, which has no face
  double stemming;        // above the uppermost charge, along the hole [m]
  double mass_per_metre;  // of its heaviest charge [kg/m]
  double top_per_metre;   // of its uppermost charge [kg/m]
  double top_length;      // of that [m]
};

// Throws NotMeasurable where the scene is no bench or the mass of a charge is not known.
std::vector<FlyrockHole> flyrock_holes(const ResultFolder& folder);

}  // namespace muckpile
