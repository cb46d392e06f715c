// SPDX-License-Identifier: GPL-2.0-or-later
// A blast plan hole by hole, and its picture.
// Scope: the first deck to fire stands for its hole.
#pragma once

#include <string>
#include <vector>

#include "draw/canvas.h"
#include "explosive/charge_window.h"
#include "measure/burden_relief.h"
#include "measure/hole_polygons.h"

namespace muckpile {

struct PlannedHole {
  std::string name;
  Vec2 collar;                 // [m]
  Vec2 charge;                 // middle of its decks [m]
  double fires = 0.0;          // its first deck [s]
  double mass = 0.0;           // NaN: not known [kg]
  double within_window = 0.0;  // explosive of all decks in the 8 ms that begin with it [kg]
  Relief relief{};             // numbers of holes in the plan
};

// `charges` are those of the table's decks. `to_face` has the least way to a free face of each
// deck [m], NaN where it is not known; it may be empty.
std::vector<PlannedHole> planned_holes(const HoleTable& table,
                                       const std::vector<TimedCharge>& charges,
                                       const std::vector<double>& to_face);

// x to the right, y up, equal scales; firing times, lines of equal time, which hole fires towards
// which, and the rock of each hole where its outlines are given.
Canvas draw_plan(const HoleTable& table, const std::vector<PlannedHole>& plan,
                 const std::vector<HolePolygon>& outlines = {});

}  // namespace muckpile
