// SPDX-License-Identifier: GPL-2.0-or-later
// The rock of each hole in plan at one height, as hole_of_blocks (measure/hole_rock.h) counts
// blocks. Scope: in front of a hole that throws to a side of its own the face is taken as a line
// across its direction.
#pragma once

#include <string>
#include <vector>

#include "geometry/shape/polygon.h"
#include "measure/hole_rock.h"

namespace muckpile {

struct HolePolygon {
  std::string hole;
  std::vector<Vec2> corners;  // counter-clockwise; empty where the hole has no rock there [m]
};

// How far the rock reaches in plan, and where it is cut.
struct PlanCut {
  double height;   // [m]
  Vec2 low, high;  // of the rock before the blast [m]
};

// Of each hole one; several one after the other, of rock that throws to several sides, where that
// of other holes parts it, and clockwise where other rock lies within it.
std::vector<HolePolygon> hole_polygons(const std::vector<PatternHole>& holes,
                                       const BenchPlanes& planes, const PlanCut& cut);

}  // namespace muckpile
