// SPDX-License-Identifier: GPL-2.0-or-later
// Fines of the rock around charges by a law: what lies within some hole radii of a charge is
// crushed to sizes of a Rosin-Rammler curve.
// Scope: an estimate beside a simulation, never part of it. The second component of Djordjevic's
// two-component model; its mass is that of a crushed zone, its sizes are chosen by the user.
#pragma once

#include <vector>

#include "io/blocks_file.h"
#include "io/charges.h"

namespace muckpile {

struct FinesLaw {
  double radius;    // of the crushed rock, in hole radii, > 1
  double top;       // 99 % of the crushed mass passes this size [m]
  double exponent;  // of Rosin-Rammler

  // Share of the crushed mass that is finer: 1 - 0.01^((size/top)^exponent).
  [[nodiscard]] double passing(double size) const;
};

struct ChargedHole {
  Charge charge;       // the axis of the explosive, and the crushed zone of the cut
  double hole_radius;  // [m]
};

struct CrushedRock {
  double without_blocks = 0.0;   // between the holes and the crushed zones, which the cut leaves
                                 // out [kg]
  std::vector<double> of_block;  // of each block's mass [kg]
  [[nodiscard]] double mass() const;
};

// Of rock that was broken out: a direction from a charge counts as far as the blocks that stood
// there were, and what the cut has left out counts with the first block behind it. By samples: the
// mass is exact to about a hundredth.
CrushedRock crushed_rock(const FinesLaw& law, const std::vector<ChargedHole>& holes,
                         const std::vector<StartBlock>& blocks, const std::vector<char>& moved);

}  // namespace muckpile
