// SPDX-License-Identifier: GPL-2.0-or-later
// The burden of each hole in plan at one height: between it and the row in front of it, or the
// face, to half way to the holes beside it and half a spacing beside the outermost ones. Scope: as
// hole_of_blocks (measure/hole_rock.h) counts blocks; holes that throw to several sides are bounded
// each by itself where no other hole stands.
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

std::vector<HolePolygon> hole_polygons(const std::vector<PatternHole>& holes,
                                       const BenchPlanes& planes, const PlanCut& cut);

}  // namespace muckpile
